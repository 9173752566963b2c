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

/// The problem with its file, where it has none. It is the assignments' when it lies in what they set, or
/// when the text is right without them, as `is_right()` says.
template <class IsRight>
Problem blamed(Problem problem, const std::string& file, const std::vector<Assignment>& assignments,
               const IsRight& is_right) {
    if (!problem.file.empty()) return problem;
    const bool theirs = !assignments.empty() && (is_assigned(problem.pointer, assignments) || is_right());
    problem.file = theirs ? "--set" : file;
    return problem;
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
    try {
        MemoryShare share;  // until the scene is made
        Json document = read_json(text, file, &share);
        const TakenApart taken_apart(document);
        share.add(need_of_scene(text));
        return read_assigned(document, assignments);
    } catch (ProblemFound& found) {
        return blamed(std::move(found.problem), file, assignments,
                      [&] { return problem_of(parse_scene(text, file)) == nullptr; });
    } catch (const Refused& refused) {
        return memory_problem(refused, file);
    }
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
    try {
        const MemoryShare share(share_.need());  // of the copy, which is assigned to
        Json document;
        const TakenApart taken_apart(document);
        copy_json(json_, document);
        return read_assigned(document, assignments);
    } catch (ProblemFound& found) {
        return blamed(std::move(found.problem), file_, assignments,
                      [&] { return problem_of(scene_with({})) == nullptr; });
    } catch (const Refused& refused) {
        return memory_problem(refused, file_);
    }
}

}  // namespace glint
