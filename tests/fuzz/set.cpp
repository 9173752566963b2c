// Assignments of `--set`, one per line, such as "/lights/0/intensity=2" -> a changed scene, or a one-line
// problem.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/fields/scene_fields.h"
#include "models/scene_file/scene_file.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/json_mutator.h"

using namespace glint;
using fuzz::require;

namespace {

constexpr const char* base = R"({"glint": 1, "lights": [{"type": "spot"}, {"type": "directional",
"position": [0, 0, 1, 0]}], "objects": [{"mesh": {"primitive": "cube"}}]})";

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// A pointer to a number of the scene, or a slightly wrong one.
std::string random_pointer(std::mt19937& random) {
    static const Scene scene = std::get<Scene>(parse_scene(base, "s.json"));
    static const std::vector<SceneNumber> numbers = numbers_of(scene);
    std::string pointer = numbers[random() % numbers.size()].pointer;
    for (std::size_t up = random() % 3; up > 0 && pointer.rfind('/') > 0; --up)
        pointer.resize(pointer.rfind('/'));
    return pointer;
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed) {
    std::mt19937 random(seed);
    if (random() % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
    std::vector<std::string_view> lines = lines_of(fuzz::text_of(data, size));
    const std::string line = random_pointer(random) + "=" + json_line(fuzz::random_leaf(random));
    const std::size_t at = random() % (lines.size() + 1);
    if (at == lines.size() || random() % 4 == 0)
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), line);
    else
        lines[at] = line;
    std::string text;
    for (const std::string_view l : lines) text.append(l).append("\n");
    return fuzz::put(text, data, max_size);
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<Assignment> assignments;
    for (const std::string_view line : lines_of(fuzz::text_of(data, size))) {
        Result<Assignment> assignment = parse_assignment(line);
        if (problem_of(assignment)) continue;
        assignments.push_back(std::get<Assignment>(std::move(assignment)));
    }
    const Result<Scene> set = parse_scene(base, "s.json", assignments);
    if (const Problem* problem = problem_of(set)) {
        require(problem->text().find('\n') == std::string::npos, "a problem is reported on one line");
        require(problem->file == "--set" || assignments.empty(), "the problem is in the assignments");
        return 0;
    }
    const Result<Scene> again = parse_scene(scene_text(std::get<Scene>(set)), "s.json");
    require(!problem_of(again) && std::get<Scene>(again) == std::get<Scene>(set),
            "reading the written text gives the changed scene");
    return 0;
}
