#include "models/scene_file/scene_file.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "models/json/json_reader.h"
#include "models/scene_file/read_scene.h"

namespace glint {
namespace {

/// The scene of a document with assignments. Throws ProblemFound; one without a file is about the scene.
Scene read_assigned(Json& document, const std::vector<Assignment>& assignments) {
    if (document.is_object()) apply_assignments(document, assignments);
    return read_scene(Node(document));
}

/// Returns what read() returns, or the problem that it throws. A problem without a file is the assignments'
/// when it lies in what they set, or when the text is right without them, as `is_right()` says.
template <class Read, class IsRight>
Result<Scene> scene_or_problem(const Read& read, const std::string& file,
                               const std::vector<Assignment>& assignments, const IsRight& is_right) {
    try {
        return read();
    } catch (ProblemFound& found) {
        Problem problem = std::move(found.problem);
        if (!problem.file.empty()) return problem;
        const bool theirs = !assignments.empty() && (is_assigned(problem.pointer, assignments) || is_right());
        problem.file = theirs ? "--set" : file;
        return problem;
    } catch (const Refused& refused) {
        return memory_problem(refused, file);
    }
}

/// Bytes of the scene that JSON text holds: of its strings, at most.
MemoryNeed need_of_scene(std::string_view text) { return memory_need(MemoryUse::Files, text.size()); }

}  // namespace

Result<Assignment> parse_assignment(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string expected = "POINTER=JSON, such as /display/exposure=2";
    if (equals == std::string_view::npos)
        return Problem{"--set", "", in_quotes(text) + " has no \"=\"", expected};
    if (!text.starts_with('/'))
        return Problem{"--set", "", in_quotes(text) + " does not begin with \"/\"", expected};
    return Assignment{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

Result<Scene> parse_scene(std::string_view text, const std::string& file,
                          const std::vector<Assignment>& assignments) {
    const auto read = [&] {
        MemoryShare share;  // until the scene is made
        Json document = read_json(text, file, &share);
        const TakenApart taken_apart(document);
        share.add(need_of_scene(text));
        return read_assigned(document, assignments);
    };
    return scene_or_problem(read, file, assignments,
                            [&] { return problem_of(parse_scene(text, file)) == nullptr; });
}

SceneJson::SceneJson(std::string_view text, std::string file) : file_(std::move(file)) {
    try {
        json_ = read_json(text, file_, &share_);
        share_.add(need_of_scene(text));
    } catch (ProblemFound& found) {
        problem_ = std::move(found.problem);
    } catch (const Refused& refused) {
        problem_ = memory_problem(refused, file_);
    }
}

Result<Scene> SceneJson::scene_with(const std::vector<Assignment>& assignments) const {
    if (problem_) return *problem_;
    const auto read = [&] {
        const MemoryShare share(share_.need());  // of the copy, which is assigned to
        Json document;
        const TakenApart taken_apart(document);
        copy_json(json_, document);
        return read_assigned(document, assignments);
    };
    return scene_or_problem(read, file_, assignments, [&] { return problem_of(scene_with({})) == nullptr; });
}

}  // namespace glint
