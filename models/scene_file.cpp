#include "models/scene_file.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "models/json_reader.h"
#include "models/scene_read.h"
#include "models/scene_set.h"

namespace glint {
namespace {

void check_version(const Node& root) {
    if (!root.value().is_object()) root.wrong_type("an object, such as {\"glint\": 1}");
    if (!root.has("glint"))
        root.fail("the key \"glint\" is missing", "\"glint\": 1, the version of the format");
    root.with("glint", [](const Node& version) {
        if (!version.value().is_number()) version.wrong_type("1, the version of the format");
        const double number = version.value().get<double>();
        if (number != 1) version.fail(fmt::format("version {} is not known", number), "1");
    });
}

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
    if (assigned.is_object()) apply_assignments(assigned, assignments);
    std::optional<Problem> problem = problem_in(assigned);
    if (!problem) return read_scene(Node(assigned));
    const bool theirs = is_assigned(problem->pointer, assignments) || !problem_in(document);
    problem->file = theirs ? "--set" : file;
    throw ProblemFound{*std::move(problem)};
}

}  // namespace

Scene read_scene(const Node& root) {
    Scene scene;
    check_version(root);
    root.allow_keys({"glint", "camera", "global_ambient", "lights", "objects", "shading", "npr", "display"});
    root.with("camera", [&](const Node& at) { scene.camera = read_camera(at); });
    read(root, "global_ambient", scene.global_ambient, at_least_zero);
    root.with("lights", [&](const Node& at) {
        at.each(max_lights, "lights", [&](const Node& n) { scene.lights.push_back(read_light(n)); });
    });
    root.with("objects", [&](const Node& at) {
        at.each(max_objects, "objects", [&](const Node& n) { scene.objects.push_back(read_object(n)); });
    });
    root.with("shading", [&](const Node& at) { scene.shading = read_shading(at); });
    root.with("npr", [&](const Node& at) { scene.npr = read_npr(at); });
    root.with("display", [&](const Node& at) { scene.display = read_display(at); });
    return scene;
}

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
        const Json document = read_json(text, file);
        if (!assignments.empty()) return read_assigned(document, file, assignments);
        return read_scene(Node(document));
    } catch (ProblemFound& found) {
        if (found.problem.file.empty()) found.problem.file = file;
        return std::move(found.problem);
    }
}

}  // namespace glint
