// glint export: writes a scene in a format that other programs read.
#include <filesystem>
#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"

namespace glint {
namespace {

struct ExportArguments {
    SceneArguments scene;
    std::string out;
};

Outcome export_scene(const ExportArguments& arguments) {
    require_file(arguments.scene);
    require_given(arguments.out, "-o", "a .glb file");
    if (lower_extension(arguments.out) != ".glb")
        throw wrong_usage("-o", arguments.out + " has a different extension", ".glb");
    require_writable(arguments.out);
    const SceneDocument document = open_scene(arguments.scene);
    require_not_read(arguments.out);
    const std::string name =
        with_invalid_replaced(std::filesystem::path(arguments.scene.file).stem().string());
    Result<GltfWritten> made = glb_of(document.scene, name);
    if (auto* problem = std::get_if<Problem>(&made)) problem->file = arguments.scene.file;
    const GltfWritten written = take(std::move(made));
    (void)take(write_file(arguments.out, written.bytes));
    Warnings warnings = document.warnings;
    warnings.insert(warnings.end(), written.warnings.begin(), written.warnings.end());
    return {{}, warnings, ExitStatus::Done};
}

Run declare_export(Options& options) {
    auto arguments = std::make_shared<ExportArguments>();
    add_scene(options, arguments->scene);
    add_text(options, "-o", "OUT", "the .glb file to write", arguments->out);
    return [arguments] { return export_scene(*arguments); };
}

}  // namespace

Command export_command() {
    return {"export", "FILE -o OUT.glb", "write a scene as glTF 2.0, for Blender and other programs",
            "glint export museum.json -o museum.glb", declare_export};
}

}  // namespace glint
