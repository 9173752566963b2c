#include "models/scene_file/scene_file.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "models/json/json_reader.h"
#include "models/scene_file/read_scene.h"

namespace glint {
namespace {

std::optional<Problem> problem_in(const Json& document) {
    try {
        (void)read_scene(Node(document));
    } catch (const ProblemFound& found) {
        return found.problem;
    }
    return std::nullopt;
}

/// The scene of a document with assignments. A problem is theirs when it lies in what they set, or when the
/// document is right without them.
Scene read_assigned(const Json& document, const std::string& file,
                    const std::vector<Assignment>& assignments) {
    Json assigned = document;
    const TakenApart taken_apart(assigned);
    if (assigned.is_object()) apply_assignments(assigned, assignments);
    std::optional<Problem> problem = problem_in(assigned);
    if (!problem) return read_scene(Node(assigned));
    const bool theirs = is_assigned(problem->pointer, assignments) || !problem_in(document);
    problem->file = theirs ? "--set" : file;
    throw ProblemFound{*std::move(problem)};
}

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
        Json document = read_json(text, file);
        const TakenApart taken_apart(document);
        if (!assignments.empty()) return read_assigned(document, file, assignments);
        return read_scene(Node(document));
    } catch (ProblemFound& found) {
        if (found.problem.file.empty()) found.problem.file = file;
        return std::move(found.problem);
    }
}

}  // namespace glint
