#include "models/scene_file/scene_file.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "models/json/json_reader.h"
#include "models/scene_file/read_scene.h"

namespace glint {
namespace {

/// The scene of JSON text with assignments. Throws ProblemFound; one without a file is about the scene.
Scene read_assigned(std::string_view text, const std::string& file,
                    const std::vector<Assignment>& assignments) {
    MemoryShare share;  // until the scene is made
    Json document = read_json(text, file, &share);
    const TakenApart taken_apart(document);
    share.add(memory_need(MemoryUse::Files, text.size()));  // at most, of the scene's strings
    if (document.is_object()) apply_assignments(document, assignments);
    return read_scene(Node(document));
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
        return read_assigned(text, file, assignments);
    } catch (ProblemFound& found) {
        if (!found.problem.file.empty()) return std::move(found.problem);
        // It is the assignments' when it lies in what they set, or when the text is right without them.
        const bool theirs = !assignments.empty() && (is_assigned(found.problem.pointer, assignments) ||
                                                     problem_of(parse_scene(text, file)) == nullptr);
        found.problem.file = theirs ? "--set" : file;
        return std::move(found.problem);
    } catch (const Refused& refused) {
        return memory_problem(refused, file);
    }
}

}  // namespace glint
