// Bytes of a PNG -> its embedded scene.

#include <variant>

#include "models/io/png_info.h"
#include "models/scene_file/scene_file.h"
#include "tests/fuzz/fuzz.h"

using namespace glint;
using fuzz::require;

constexpr std::size_t most_text = 1 << 16;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<PngInfo> png = png_info(fuzz::text_of(data, size), png_scene_keyword, most_text, "p.png");
    if (const Problem* problem = problem_of(png)) {
        require(problem->text().find('\n') == std::string::npos, "a problem is reported on one line");
        return 0;
    }
    const std::string& text = *std::get<PngInfo>(png).text(png_scene_keyword);
    require(text.size() <= most_text, "a text is no longer than requested");
    const Result<Scene> scene = parse_scene(text, "p.png");
    if (const Problem* problem = problem_of(scene))
        require(problem->text().find('\n') == std::string::npos, "a problem is reported on one line");
    return 0;
}
