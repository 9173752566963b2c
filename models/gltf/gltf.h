#pragma once
// glTF 2.0 in and out: .gltf and .glb. Every file may be hostile, so we read it with our own reader: a parser
// that trusts counts, follows URIs by itself or cannot say where an error is would not do.
// Source: Khronos, "glTF 2.0 Specification"; KHR_lights_punctual; KHR_mesh_quantization.

#include <memory>
#include <string>
#include <string_view>

#include "models/mesh/mesh.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// The generator that our own files name; lights of such files are taken as bright as they say, and there are
/// no others.
inline constexpr std::string_view gltf_generator = "Glint";

/// True for a path that ends in .gltf or .glb, in any case.
[[nodiscard]] bool is_gltf_path(const std::string& path);

struct GltfDocument;  // models/gltf/gltf_document.h

/// A glTF file in memory with its buffers: its JSON is whole and its buffers are as long as they say; all
/// else is checked where it is read. A problem has the path and, where there is one, the pointer into the
/// JSON.
class GltfFile {
  public:
    /// Reads buffers in files beside `path`, but no images. The bytes tell .glb from JSON.
    [[nodiscard]] static Result<GltfFile> read(const std::string& path);
    [[nodiscard]] static Result<GltfFile> parse(std::string bytes, const std::string& path);

    /// Returns primitive number `part`, counted through all meshes, as a finished mesh. Vertices at one point
    /// share a position; normals stay with their corners.
    [[nodiscard]] Result<Mesh> mesh(int part) const;

    struct Content {
        Scene scene;  // objects name `file_name` and the part; their meshes are not loaded
        bool has_camera = false, has_lights = false;
        bool is_ours = false;  // written by Glint; of others, lights are in candela and lux of their choice
        glm::dvec3 ahead{0, 0, -1};  // where the camera looks, unit: its target is rounded
        Warnings warnings;           // what is left out, one line a kind
        Warnings objects_left_out;   // those of them that say why there are fewer objects
    };
    /// Converts the file's scene (the first one where it names none): an object for each primitive with
    /// triangles of each node, the camera of the first node that has one, and the lights. A light below that
    /// camera's node moves with the viewer. Materials are for cook-torrance.
    [[nodiscard]] Result<Content> content(const std::string& file_name) const;

  private:
    explicit GltfFile(std::shared_ptr<const GltfDocument> document) : document_(std::move(document)) {}
    std::shared_ptr<const GltfDocument> document_;
};

/// A scene as a .glb file, with one warning for each kind of thing that glTF cannot express.
struct GltfWritten {
    std::string bytes;
    Warnings warnings;
};
/// Writes meshes with the normals that they are drawn with, transforms, the camera with the lights that move
/// with it, lights of KHR_lights_punctual, and materials as metallic-roughness. Precondition: meshes are
/// loaded. Whether the file can be opened is not checked: glb_of() of models/scene_file/scene_file.h does.
[[nodiscard]] Result<GltfWritten> unchecked_glb_of(const Scene& scene, const std::string& name);

}  // namespace glint
