// glint info: describes a file. glint schema: prints the JSON schema of scene files, for editors and other
// programs.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/mesh/formats/mesh_file.h"
#include "models/scene_file/scene_file.h"
#include "renderer/answers/answers.h"

namespace glint {
namespace {

struct InfoArguments {
    SceneArguments scene;
    std::optional<PictureSize> size;
    bool as_text = false;
};

/// Returns "NAME: 8 vertices, 6 faces", then a line for each finding and its effect, followed by the first
/// positions where the finding occurs.
std::string report_of(const std::string& name, const Json& mesh) {
    constexpr std::size_t max_places = 3;
    std::string text = fmt::format("{}: {} vertices, {} faces, {} edges; normals: {}\n", name,
                                   mesh["vertices"].get<std::size_t>(), mesh["faces"].get<std::size_t>(),
                                   mesh["edges"].get<std::size_t>(), mesh["normals"].get<std::string>());
    if (mesh["findings"].empty()) text += "  no problems found\n";
    for (const Json& finding : mesh["findings"]) {
        text += fmt::format("  {}: {}\n", finding["what"].get<std::string>(),
                            finding["effect"].get<std::string>());
        const Json& places = finding["places"];
        for (std::size_t i = 0; i < places.size() && i < max_places; ++i)
            text += fmt::format("    at {}\n", fmt::join(places[i].get<std::vector<float>>(), " "));
    }
    return text;
}

/// Returns the report on a mesh, or on each object in a scene.
std::string report_of(const Json& info, const std::string& file) {
    if (!info.contains("objects")) return report_of(file, info);
    std::string text;
    for (const Json& object : info["objects"])
        text += report_of(on_one_line(object["name"].get<std::string>()), object["mesh"]);
    return text;
}

Outcome info(const InfoArguments& arguments) {
    const SceneDocument document = open_scene(arguments.scene);
    const std::vector<Object>& objects = document.scene.objects;
    const bool of_mesh = is_mesh_path(arguments.scene.file) && objects.size() == 1;
    const Json json = of_mesh ? info_json(*objects.front().mesh, objects.front().normals.source)
                              : info_json(document.scene, size_to_draw(arguments.size, document));
    return {arguments.as_text ? report_of(json, on_one_line(arguments.scene.file)) : json_text(json),
            document.warnings, ExitStatus::Done};
}

Run declare_info(Options& options) {
    auto arguments = std::make_shared<InfoArguments>();
    add_scene(options, arguments->scene);
    add_size(options, arguments->size);
    options.add_value("--format", "FORMAT", "json (default) or text, a list of problems with the meshes",
                      [&as_text = arguments->as_text](const std::string& text) {
                          as_text = read_word("--format", text, {"json", "text"}) == 1;
                      });
    return [arguments] { return info(*arguments); };
}

Run declare_schema(Options& /*options*/) {
    return [] { return Outcome{scene_schema(), {}, ExitStatus::Done}; };
}

}  // namespace

Command schema_command() {
    return {"schema", "", "print the JSON Schema (2020-12) of the scene file",
            "glint schema > scene.schema.json", declare_schema};
}

Command info_command() {
    return {"info", "FILE", "describe a mesh or a scene, and problems with its meshes",
            "glint info bunny.obj", declare_info};
}

}  // namespace glint
