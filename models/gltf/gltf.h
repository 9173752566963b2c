#pragma once
// glTF 2.0 in and out: .gltf and .glb. Everything is read as if a stranger had made it to hurt us, so by our
// own reader: a parser that trusts counts, follows URIs by itself and says no place is none for that.
// Source: Khronos, "glTF 2.0 Specification"; KHR_lights_punctual; KHR_mesh_quantization.

#include <memory>
#include <string>
#include <string_view>

#include "models/mesh/mesh.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// What files that we write say they come from: their lights are as bright as they say.
inline constexpr std::string_view gltf_generator = "Glint";

/// True for a path that ends in .gltf or .glb, in any case.
[[nodiscard]] bool is_gltf_path(const std::string& path);

struct GltfDocument;  // models/gltf/gltf_document.h

/// A glTF file in memory with its buffers: its JSON is whole and its buffers are as long as they say; all
/// else is checked where it is read. A problem has the path and, where there is one, the pointer into the
/// JSON.
class GltfFile {
  public:
    /// Buffers in files beside `path` are read, images are not. .glb or JSON, as the bytes say.
    [[nodiscard]] static Result<GltfFile> read(const std::string& path);
    [[nodiscard]] static Result<GltfFile> parse(std::string bytes, const std::string& path);

    /// The primitive of that number, counted through all meshes; finished. Vertices at one place share a
    /// position, normals stay with their corners. Throws Refused and LoadCancelled.
    [[nodiscard]] Result<Mesh> mesh(int part) const;

    struct Content {
        Scene scene;  // objects name `file_name` and the part; their meshes are not loaded
        bool has_camera = false, has_lights = false;
        bool scales_lights = true;  // they are in candela and lux of somebody's choice
        Warnings warnings;          // what is left out, one line a kind
    };
    /// The file's scene (its first where it names none): one object a primitive with triangles of a node, the
    /// camera of the first node that has one, lights. A light below that camera's node moves with the viewer.
    /// Materials are for cook-torrance.
    [[nodiscard]] Result<Content> content(const std::string& file_name) const;

  private:
    explicit GltfFile(std::shared_ptr<const GltfDocument> document) : document_(std::move(document)) {}
    std::shared_ptr<const GltfDocument> document_;
};

/// A scene as a .glb file, and what of it glTF cannot say, one line a kind.
struct GltfWritten {
    std::string bytes;
    Warnings warnings;
};
/// Meshes with the normals that they are drawn with, transforms, the camera with what rides along, lights of
/// KHR_lights_punctual, materials as metallic-roughness. Precondition: meshes are loaded.
[[nodiscard]] Result<GltfWritten> glb_of(const Scene& scene, const std::string& name);

}  // namespace glint
