#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "models/json/json_value.h"
#include "ui/export/clipboard.h"
#include "ui/shell/shell_word.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using Json = JsonValue;

bool same_keys(const Json& a, const Json& b) {
    return a.members().size() == b.members().size() &&
           std::all_of(a.members().begin(), a.members().end(),
                       [&b](const auto& member) { return b.find(member.first) != nullptr; });
}

/// Of a mesh or a projection some keys only go with others: it is set whole.
bool is_one_value(const std::string& pointer) {
    return pointer.ends_with("/mesh") || pointer.ends_with("/projection") || pointer.ends_with("/mistakes");
}

/// Appends " --set POINTER=JSON" for each smallest part in which `b` differs from `a`.
void append_sets(std::string& command, const Json& a, const Json& b, const std::string& pointer) {
    if (a == b) return;
    const bool members = a.is_object() && b.is_object() && same_keys(a, b) && !is_one_value(pointer);
    const bool items =
        !b.elements().empty() && a.elements().size() == b.elements().size() && b.elements()[0].is_object();
    if (members) {
        for (const auto& [name, value] : b.members())
            append_sets(command, *a.find(name), value, pointer + "/" + name);
    } else if (items) {
        for (std::size_t i = 0; i < b.elements().size(); ++i)
            append_sets(command, a.elements()[i], b.elements()[i], fmt::format("{}/{}", pointer, i));
    } else {
        command += " --set " + shell_word(pointer + "=" + b.text());
    }
}

Scene with_absolute_meshes(Scene scene, const std::string& mesh_dir) {
    for (Object& object : scene.objects)
        if (auto* file = std::get_if<MeshFile>(&object.source)) {
            std::error_code failed;
            const fs::path whole = fs::weakly_canonical(fs::path(mesh_dir) / file->path, failed);
            if (!failed) file->path = whole.string();
        }
    return scene;
}

}  // namespace

std::string render_command_text(const SceneDocument& document, const Scene& in_file, PictureSize size,
                                int samples, const std::string& out) {
    std::error_code failed;
    const bool has_file =
        !document.path.empty() && document.path != "-" && fs::is_regular_file(document.path, failed);
    Scene base, shown;
    std::string command;
    if (has_file) {
        base = in_file;
        shown = with_mesh_paths_from(document.scene, document.mesh_dir, directory_of(document.path));
        command = "glint render " + shell_word(fs::absolute(document.path, failed).string());
    } else {
        shown = with_absolute_meshes(document.scene, document.mesh_dir);
        command = R"(echo '{"glint": 1}' | glint render -)";
    }
    append_sets(command, *Json::parse(scene_text(base)), *Json::parse(scene_text(shown)), "");
    command += fmt::format(" --size {}x{}", size.width, size.height);
    if (samples > 1) command += fmt::format(" --samples {}", samples);
    return command + " -o " + shell_word(out);
}

}  // namespace glint
