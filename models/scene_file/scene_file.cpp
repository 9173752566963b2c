#include "models/scene_file/scene_file.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "models/json/json_reader.h"
#include "models/scene_file/read_scene.h"

namespace glint {
namespace {

bool is_right(const Json& document) {
    try {
        (void)read_scene(Node(document));
    } catch (const ProblemFound&) {
        return false;
    }
    return true;
}

/// The scene of a document with assignments. A problem is theirs when it lies in what they set, or when the
/// document is right without them.
Scene read_assigned(const Json& document, const std::string& file,
                    const std::vector<Assignment>& assignments) {
    Json assigned = document;
    const TakenApart taken_apart(assigned);
    if (assigned.is_object()) apply_assignments(assigned, assignments);
    try {
        return read_scene(Node(assigned));
    } catch (ProblemFound& found) {
        const bool theirs = is_assigned(found.problem.pointer, assignments) || is_right(document);
        found.problem.file = theirs ? "--set" : file;
        throw;
    }
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
