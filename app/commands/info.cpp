// glint info: describes a file. glint schema: prints the JSON schema of scene files, for editors and other
// programs.
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
};

Outcome info(const InfoArguments& arguments) {
    const SceneDocument document = open_scene(arguments.scene);
    const std::vector<Object>& objects = document.scene.objects;
    const bool of_mesh = is_mesh_path(arguments.scene.file) && objects.size() == 1;
    const Json json = of_mesh ? info_json(*objects.front().mesh, objects.front().normals.source)
                              : info_json(document.scene, size_to_draw(arguments.size, document));
    return {json_text(json), document.warnings, ExitStatus::Done};
}

Run declare_info(Options& options) {
    auto arguments = std::make_shared<InfoArguments>();
    add_scene(options, arguments->scene);
    add_size(options, arguments->size);
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
    return {"info", "FILE", "describe a mesh or a scene, as JSON", "glint info bunny.obj", declare_info};
}

}  // namespace glint
