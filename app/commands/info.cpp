// glint info: what a file holds.
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/json/json_value.h"
#include "models/mesh_formats/mesh_file.h"

namespace glint {
namespace {

using Json = JsonValue;

struct InfoArguments {
    SceneArguments scene;
    PictureSize size;
};

Json json_of(glm::vec3 v) { return {v.x, v.y, v.z}; }

/// Four rows of four. GLM counts columns first.
Json json_of(const glm::dmat4& m) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) rows.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
    return rows;
}

Json json_of(const MeshInfo& info) {
    return {{"vertices", info.vertices},
            {"faces", info.faces},
            {"triangles", info.triangles},
            {"quads", info.quads},
            {"polygons", info.polygons},
            {"edges", info.edges},
            {"boundary_edges", info.boundary_edges},
            {"non_manifold_edges", info.non_manifold_edges},
            {"degenerate_faces", info.degenerate_faces},
            {"duplicate_faces", info.duplicate_faces},
            {"bounds", {{"min", json_of(info.bounds.min)}, {"max", json_of(info.bounds.max)}}},
            {"normals", info.normals},
            {"warnings", info.warnings},
            {"load_ms", info.load_ms}};
}

Json json_of(const Scene& scene, PictureSize size) {
    Json objects = Json::array();
    std::map<const Mesh*, Json> meshes;  // each is looked at once, however many objects share it
    for (const Object& object : scene.objects) {
        const auto [mesh, is_new] = meshes.try_emplace(object.mesh.get());
        if (is_new) mesh->second = json_of(mesh_info(*object.mesh));
        objects.push_back({{"name", object.name}, {"mesh", mesh->second}});
    }
    return {{"lights", scene.lights.size()},
            {"objects", objects},
            {"matrices",
             {{"view_from_world", json_of(view_from_world(scene.camera))},
              {"world_from_view", json_of(world_from_view(scene.camera))},
              {"clip_from_view", json_of(clip_from_view(scene.camera.projection, size))}}}};
}

Outcome info(const InfoArguments& arguments) {
    const SceneDocument document = open_scene(arguments.scene);
    const std::vector<Object>& objects = document.scene.objects;
    const bool of_mesh = is_mesh_path(arguments.scene.file) && objects.size() == 1;
    const Json json =
        of_mesh ? json_of(mesh_info(*objects.front().mesh)) : json_of(document.scene, arguments.size);
    return {json_text(json), document.warnings, ExitStatus::Done};
}

Run declare(Options& options) {
    auto arguments = std::make_shared<InfoArguments>();
    add_scene(options, arguments->scene);
    add_size(options, arguments->size);
    return [arguments] { return info(*arguments); };
}

}  // namespace

Command info_command() {
    return {"info", "FILE", "tells what a mesh or a scene holds, as JSON", "glint info bunny.obj", declare};
}

}  // namespace glint
