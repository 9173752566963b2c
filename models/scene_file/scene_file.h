#pragma once
// The scene file, version 1 (docs/scene_file.md): read, checked and written. What is written reads back
// equal.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// The keyword of the PNG text chunk (iTXt) in which a picture carries its scene.
inline constexpr std::string_view png_scene_keyword = "glint-scene";
/// The keyword of the chunk that stands beside it where the picture shows the scene as fitted() to its size
/// (PictureSize::keeps_width): that size, "640x716".
inline constexpr std::string_view png_field_keyword = "glint-field";
/// The keyword of the chunk with the picture's samples a pixel, where it has several: "4".
inline constexpr std::string_view png_samples_keyword = "glint-samples";

/// One `--set /pointer=JSON`.
struct Assignment {
    std::string pointer;  // RFC 6901
    std::string json;     // a JSON value, or a bare word taken as a string
    bool operator==(const Assignment&) const = default;
};

/// A scene with what is needed to load and save it.
struct SceneDocument {
    Scene scene;           // meshes loaded
    std::string path;      // of the scene or mesh file; "-" for standard input; empty for a new scene
    std::string mesh_dir;  // what relative mesh paths are relative to
    Warnings warnings;
    FileStamp stamp = {};  // of the file at `path` when it was read or written; none for a new scene
    std::optional<PictureSize> fitted_to = {};  // of a picture that shows the scene so
    // Of the picture that carries the scene: its own size, and its samples a pixel.
    std::optional<PictureSize> picture_size = {};
    int picture_samples = 1;
    std::vector<Assignment> assignments = {};  // that were applied to what the file holds
};

/// Splits "POINTER=JSON"; a problem (file "--set") when there is no '=' or the pointer does not begin with
/// '/'.
[[nodiscard]] Result<Assignment> parse_assignment(std::string_view text);

/// Text -> scene, without its meshes (Object::mesh stays null). `file` is only for messages. Assignments are
/// applied to the JSON as written, in order, making missing parents; the whole is checked once, after the
/// last. What is wrong in an assignment has the file "--set".
[[nodiscard]] Result<Scene> parse_scene(std::string_view text, const std::string& file,
                                        const std::vector<Assignment>& assignments = {});

/// JSON text of a scene: every key (of mistakes only those made), floats in the shortest form that reads back
/// equal, ends with a newline.
[[nodiscard]] std::string scene_text(const Scene& scene);

/// Loads the mesh of every object whose `mesh` is null. A mesh named twice is loaded once. Paths are relative
/// to `mesh_dir`. `file` and the object's pointer stand in messages about paths that cannot be read; what
/// is wrong inside a mesh file has that file and its line. On a problem the scene is left as it was.
[[nodiscard]] Result<Warnings> load_meshes(Scene& scene, const std::string& file,
                                           const std::string& mesh_dir);

/// Why no mesh can be read at `path`: "no such file"; nothing if a file is there.
[[nodiscard]] std::optional<Problem> why_no_mesh_file(const std::string& path);

/// What open_document() opens, for "expected ...".
inline constexpr const char* opened_files =
    "a scene (.json, .png, .gltf, .glb) or a mesh (.obj, .ply, .off, .stl)";

/// Anything `glint FILE` takes: a scene (.json), a picture that Glint wrote (.png), a mesh (.obj .ply .off
/// .stl; framed, with two default lights, one in world, one in camera coordinates), or "-" (a scene on
/// standard input). Meshes are loaded.
[[nodiscard]] Result<SceneDocument> open_document(const std::string& path,
                                                  const std::vector<Assignment>& assignments = {});

/// Returns what a file's relative mesh paths are relative to: its directory; empty for the working directory,
/// and for "-".
[[nodiscard]] std::string directory_of(const std::string& path);

/// Returns `path`, which is relative to `mesh_dir`, with `mesh_dir` in front. An absolute `path` is returned
/// unchanged.
[[nodiscard]] std::string path_from(const std::string& mesh_dir, const std::string& path);

/// Returns the scene with relative mesh paths that lead from the new directory where they led from the old
/// one.
[[nodiscard]] Scene with_mesh_paths_from(Scene scene, const std::string& old_directory,
                                         const std::string& new_directory);

/// The scene's text as a picture at `picture_path` carries it: mesh paths relative to `mesh_dir` become
/// relative to the picture's directory, or whole where `picture_path` is a link into another directory.
[[nodiscard]] std::string carried_scene_text(const Scene& scene, const std::string& mesh_dir,
                                             const std::string& picture_path);

/// Whether the file is a PNG that carries a scene.
[[nodiscard]] bool carries_scene(const std::string& path);

/// Writes the scene as .json beside its target and renames it into place ("-" is standard output). Mesh paths
/// are made relative to the new place, or whole where that is a link into another directory. Problems:
/// another extension, what cannot be written, a scene that would not read back equal.
[[nodiscard]] Result<SceneDocument> save_document(const SceneDocument& document, const std::string& path);

/// Returns a directional light in world coordinates and a dimmer point light at the viewer.
[[nodiscard]] std::vector<Light> default_lights();

/// A scene of one mesh, framed, with two default lights. Precondition: the mesh has a face.
[[nodiscard]] Scene scene_of_mesh(MeshPtr mesh, const std::string& path);

/// The eye of a scene without a camera of its own before it is framed: from the front, a little above.
inline constexpr glm::vec3 eye_before_framing{0.5f, 0.35f, 1};

/// Moves the camera, direction, up and angles kept, so that a sphere around all objects (or one, when
/// `object` >= 0) fits a picture from 1:1 to 16:9; near, far and an orthographic height follow. Returns
/// false, and nothing changes, when there is no loaded mesh, or no such camera within the numbers of a scene
/// file. Precondition: the camera is valid.
bool frame_camera(Scene& scene, int object = -1);

/// The scene with the assignments applied, as `--set` would, to its text with every key written out. Meshes
/// that the document has loaded are shared where their source stays; others are loaded. What is wrong in an
/// assignment has the file "--set".
[[nodiscard]] Result<Scene> scene_variant(const SceneDocument& document,
                                          const std::vector<Assignment>& assignments);

class SceneJson;

/// Many variants of one scene, each as scene_variant() makes it: the scene's text is written and read once.
class SceneVariants {
  public:
    /// Precondition: `document` lives as long as this.
    explicit SceneVariants(const SceneDocument& document);
    ~SceneVariants();
    SceneVariants(const SceneVariants&) = delete;
    SceneVariants& operator=(const SceneVariants&) = delete;
    [[nodiscard]] Result<Scene> with(const std::vector<Assignment>& assignments) const;

  private:
    const SceneDocument& document_;
    std::unique_ptr<const SceneJson> json_;
};

// A glTF file as a scene that can be drawn, and a scene as a glTF file.

struct GltfOpened {
    Scene scene;  // meshes loaded
    Warnings warnings;
};
/// Reads the file and adds what a picture needs: a camera that shows all objects and two default lights,
/// where the file has none; but a file of ours without lights is dark. Lights that are far too bright, as
/// candela and lux can be, are all divided by one factor, which a warning gives.
[[nodiscard]] Result<GltfOpened> open_gltf(const std::string& path);
/// Does the same with a file that was read already.
[[nodiscard]] Result<GltfOpened> open_gltf(const Result<GltfFile>& file, const std::string& path);

/// A scene as a .glb file (unchecked_glb_of) that can be opened: a scene of which that is not so is refused,
/// with the pointer of its value. Precondition: meshes are loaded.
[[nodiscard]] Result<GltfWritten> glb_of(const Scene& scene, const std::string& name);

/// JSON Schema, draft 2020-12, of the scene file: keys, types, ranges, words, defaults. Made of the rows of
/// models/fields/scene_fields.h. It accepts every valid scene. Conditions between numbers (near < far, an
/// area that is not zero; models/fields/scene_rules.h) are beyond it: what it accepts may still be refused by
/// the reader. Ends with a newline.
[[nodiscard]] std::string scene_schema();

}  // namespace glint
