// Bytes -> a picture by another program, as read by `diagnose`. GLINT_FUZZ_READ is the reading function.

#include <variant>

#include "models/memory_limit.h"
#include "renderer/image/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace glint;
using fuzz::require;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::uint64_t memory = 64 << 20;  // bytes: the header of a file may request gigabytes
    set_memory_limit(memory);
    try {
        const Result<Picture> read = GLINT_FUZZ_READ(fuzz::path_of_bytes(fuzz::text_of(data, size)));
        if (const Problem* problem = problem_of(read)) {
            require(problem->text().find('\n') == std::string::npos, "a problem is reported on one line");
            return 0;
        }
        const Picture& picture = std::get<Picture>(read);
        const std::size_t pixels = picture.size.pixels();
        require(picture.rgba.size() == 4 * pixels || picture.linear.size() == 3 * pixels,
                "a picture has three or four numbers per pixel");
    } catch (const LimitExceeded&) {  // the commands report it
    }
    return 0;
}
