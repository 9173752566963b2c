#pragma once
// Reads and writes glTF 2.0: .gltf and .glb. Every file may be hostile, so we use our own reader: other
// parsers trust counts, follow URIs on their own or cannot report where an error is. Source: Khronos, "glTF
// 2.0 Specification"; KHR_lights_punctual; KHR_mesh_quantization.

#include <memory>
#include <string>
#include <string_view>

#include "models/mesh/mesh.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// The generator named in our own files. Lights in these files keep their brightness, and no default lights
/// are added if such a file has no lights.
inline constexpr std::string_view gltf_generator = "Glint";

/// True for a path that ends in .gltf or .glb, ignoring case.
[[nodiscard]] bool is_gltf_path(const std::string& path);

struct GltfDocument;  // models/gltf/gltf_document.h

/// A glTF file in memory with its buffers. Its JSON is complete and its buffers have their stated lengths;
/// everything else is checked when it is read. A problem contains the path and, if possible, the pointer into
/// the JSON.
class GltfFile {
  public:
    /// Reads buffers from files next to `path`, but no images. Detects .glb or JSON by the first bytes.
    [[nodiscard]] static Result<GltfFile> read(const std::string& path);
    [[nodiscard]] static Result<GltfFile> parse(std::string bytes, const std::string& path);

    /// Returns primitive number `part`, counted across all meshes, as a finished mesh. Vertices at the same
    /// point share a position; normals stay with their corners.
    [[nodiscard]] Result<Mesh> mesh(int part) const;

    struct Content {
        Scene scene;  // objects refer to `file_name` and the part; their meshes are not loaded
        bool has_camera = false, has_lights = false;
        bool is_ours = false;  // written by Glint; other files choose their own scale for candela and lux
        glm::dvec3 ahead{0, 0, -1};  // the exact viewing direction (unit); the camera's target is rounded
        Warnings warnings;           // one line for each kind of item that was left out
        Warnings objects_left_out;   // the warnings that explain missing objects
    };
    /// Converts the file's scene, by default the first. Each node becomes an object for each of its
    /// primitives with triangles. The camera comes from the first node that has one. Lights below that
    /// camera's node move with the viewer. Materials are for the cook-torrance model. `offset` is subtracted
    /// from all positions, in double.
    [[nodiscard]] Result<Content> content(const std::string& file_name, const glm::dvec3& offset = {}) const;

  private:
    explicit GltfFile(std::shared_ptr<const GltfDocument> document) : document_(std::move(document)) {}
    std::shared_ptr<const GltfDocument> document_;
};

/// A scene as a .glb file, with one warning for each kind of feature that glTF cannot express.
struct GltfWritten {
    std::string bytes;
    Warnings warnings;
};
/// Writes meshes with the normals used to draw them, transforms, the camera with the lights that move with
/// it, KHR_lights_punctual lights, and materials as metallic-roughness. Precondition: meshes are loaded. Does
/// not check that the file can be opened again: glb_of() in models/scene_file/scene_file.h does.
[[nodiscard]] Result<GltfWritten> unchecked_glb_of(const Scene& scene, const std::string& name);

}  // namespace glint
