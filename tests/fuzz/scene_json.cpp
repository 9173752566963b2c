// Text -> scene: a scene that was read is written, and reading it back must give the same scene.

#include <variant>

#include "models/fields/scene_fields.h"
#include "models/scene_file/scene_file.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/json_mutator.h"

using namespace glint;
using fuzz::require;

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed) {
    return fuzz::mutate_json(data, size, max_size, seed);
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Scene> read = parse_scene(fuzz::text_of(data, size), "s.json");
    if (const Problem* problem = problem_of(read)) {
        const std::string line = problem->text();
        require(!problem->what.empty() && line.size() < 4096 && line.find('\n') == std::string::npos,
                "a problem is reported on one line");
        return 0;
    }
    const Scene& scene = std::get<Scene>(read);
    require(!violation_of(scene), "a scene that was read obeys the rules");
    const std::string text = scene_text(scene);
    const Result<Scene> again = parse_scene(text, "s.json");
    require(!problem_of(again), "written output can be read");
    require(std::get<Scene>(again) == scene, "reading the written text gives the same scene");
    require(scene_text(std::get<Scene>(again)) == text, "a scene that was read back is written identically");
    return 0;
}
