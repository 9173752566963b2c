#include "models/scene_file/scene_file.h"

#include <fmt/core.h>

#include <utility>

#include "models/json/json.h"
#include "models/scene_file/read_scene.h"

namespace glint {
namespace {

/// The scene of a document with assignments. Throws ProblemFound; one without a file refers to the scene.
Scene read_assigned(Json& document, const std::vector<Assignment>& assignments) {
    if (document.is_object()) apply_assignments(document, assignments);
    return read_scene(Node(document));
}

/// Attributes a problem without a file: to the assignments if its pointer is within an assigned value, or if
/// the text is valid without them (`is_right()`); else to the file.
template <class Read, class IsRight>
Result<Scene> scene_of(const Read& read, const std::string& file, const std::vector<Assignment>& assignments,
                       const IsRight& is_right) {
    Result<Scene> scene = result_of("", read);
    if (auto* problem = std::get_if<Problem>(&scene); problem != nullptr && problem->file.empty()) {
        const bool theirs =
            !assignments.empty() && (is_assigned(problem->pointer, assignments) || is_right());
        problem->file = theirs ? "--set" : file;
    }
    return scene;
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
    const auto read = [&] {
        Json document = parsed_json(text, file);
        return read_assigned(document, assignments);
    };
    return scene_of(read, file, assignments, [&] { return problem_of(parse_scene(text, file)) == nullptr; });
}

SceneJson::SceneJson(std::string_view text, std::string file)
    : file_(std::move(file)), json_(read_json(text, file_)) {}

Result<Scene> SceneJson::scene_with(const std::vector<Assignment>& assignments) const {
    if (const Problem* problem = problem_of(json_)) return *problem;
    const auto read = [&] {
        Json document = std::get<Json>(json_);
        return read_assigned(document, assignments);
    };
    return scene_of(read, file_, assignments, [&] { return problem_of(scene_with({})) == nullptr; });
}

}  // namespace glint
