#pragma once
// Reads, checks and writes the scene file, version 1 (docs/scene_file.md). Reading a written scene gives an
// equal scene.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/json/json.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// The keyword of the PNG text chunk (iTXt) that contains a picture's scene.
inline constexpr std::string_view png_scene_keyword = "glint-scene";
/// The keyword of an additional chunk with a size such as "640x716", if the picture shows the scene as
/// fitted() to that size (PictureSize::keeps_width).
inline constexpr std::string_view png_field_keyword = "glint-field";
/// The keyword of the chunk with the picture's samples per pixel, if more than one: "4".
inline constexpr std::string_view png_samples_keyword = "glint-samples";

/// One `--set /pointer=JSON`.
struct Assignment {
    std::string pointer;  // RFC 6901
    std::string json;     // a JSON value, or a bare word interpreted as a string
    bool operator==(const Assignment&) const = default;
};

/// A scene with the data to load and save it.
struct SceneDocument {
    Scene scene;           // meshes loaded
    std::string path;      // the scene or mesh file; "-" for standard input; empty for a new scene
    std::string mesh_dir;  // the base of relative mesh paths
    Warnings warnings;
    FileStamp stamp = {};  // the file's state when it was read or written; default for a new scene
    std::optional<PictureSize> fitted_to = {};  // the size to which a picture's scene is fitted()
    // The size and the samples per pixel of the picture that contains the scene.
    std::optional<PictureSize> picture_size = {};
    int picture_samples = 1;
    std::vector<Assignment> assignments = {};  // applied to the file's contents
};

/// Splits "POINTER=JSON". A problem has the file "--set": the '=' is missing, or the pointer does not begin
/// with '/'.
[[nodiscard]] Result<Assignment> parse_assignment(std::string_view text);

/// Reads a scene without its meshes (Object::mesh stays null). `file` is only used in messages. Assignments
/// are applied in order to the JSON as written, creating missing parents; the result is checked once, after
/// the last. A problem with an assignment has the file "--set".
[[nodiscard]] Result<Scene> parse_scene(std::string_view text, const std::string& file,
                                        const std::vector<Assignment>& assignments = {});

/// The JSON text of a scene: every key (but only the active mistakes), floats in the shortest form from which
/// the same value is read, and a newline at the end.
[[nodiscard]] std::string scene_text(const Scene& scene);

/// Loads the mesh of every object whose `mesh` is null. A mesh named twice is loaded once. Paths are relative
/// to `mesh_dir`. Messages about unreadable paths contain `file` and the object's pointer; messages about the
/// contents of a mesh file contain that file and its line. On a problem the scene is unchanged.
[[nodiscard]] Result<Warnings> load_meshes(Scene& scene, const std::string& file,
                                           const std::string& mesh_dir);

/// Returns why no mesh can be read at `path`: "no such file"; nullopt if a file exists.
[[nodiscard]] std::optional<Problem> why_no_mesh_file(const std::string& path);

/// The types that open_document() accepts, for "expected ...".
inline constexpr const char* opened_files =
    "a scene (.json, .png, .gltf, .glb) or a mesh (.obj, .ply, .off, .stl)";

/// Opens any argument of `glint FILE`: a scene (.json), a picture that Glint wrote (.png), a mesh (.obj .ply
/// .off .stl; framed, with two default lights, one in world, one in camera coordinates), or "-" (a scene on
/// standard input). Meshes are loaded.
[[nodiscard]] Result<SceneDocument> open_document(const std::string& path,
                                                  const std::vector<Assignment>& assignments = {});

/// Returns the base of a file's relative mesh paths: its directory; empty for the working directory, and for
/// "-".
[[nodiscard]] std::string directory_of(const std::string& path);

/// Returns `path`, which is relative to `mesh_dir`, with `mesh_dir` in front. An absolute `path` is returned
/// unchanged.
[[nodiscard]] std::string path_from(const std::string& mesh_dir, const std::string& path);

/// Returns the scene with its relative mesh paths rebased from the old directory to the new one.
[[nodiscard]] Scene with_mesh_paths_from(Scene scene, const std::string& old_directory,
                                         const std::string& new_directory);

/// The text of a scene embedded in a picture at `picture_path`: mesh paths relative to `mesh_dir` become
/// relative to the picture's directory, or absolute if `picture_path` is a link into another directory.
[[nodiscard]] std::string carried_scene_text(const Scene& scene, const std::string& mesh_dir,
                                             const std::string& picture_path);

/// The size passed to fitted() for the scene in a PNG that Glint wrote (png_field_keyword); nullopt for other
/// files.
[[nodiscard]] std::optional<PictureSize> fitted_size_in(const std::string& path);

/// Whether the file is a PNG with an embedded scene.
[[nodiscard]] bool carries_scene(const std::string& path);

/// Writes the scene as .json next to its target and renames it ("-" is standard output). Mesh paths become
/// relative to the new file, or absolute if that is a link into another directory. Problems: a different
/// extension, a failed write, a scene that would be different when read again.
[[nodiscard]] Result<SceneDocument> save_document(const SceneDocument& document, const std::string& path);

/// Returns a directional light in world coordinates and a dimmer point light at the viewer.
[[nodiscard]] std::vector<Light> default_lights();

/// A scene of one mesh, framed, with two default lights. Precondition: the mesh has at least one face.
[[nodiscard]] Scene scene_of_mesh(MeshPtr mesh, const std::string& path);

/// The eye of a scene that has no camera, before it is framed: in front, slightly above.
inline constexpr glm::vec3 eye_before_framing{0.5f, 0.35f, 1};

/// Moves the camera so that a sphere around all objects (or one, if `object` >= 0) fits a picture from 1:1 to
/// 16:9. Direction, up and angles stay the same; near, far and an orthographic height are adjusted. Returns
/// false and changes nothing if no mesh is loaded, or if such a camera exceeds the range of a scene file.
/// Precondition: the camera is valid.
bool frame_camera(Scene& scene, int object = -1);

/// The scene after applying the assignments, like `--set`, to its text with every key written out. Objects
/// with an unchanged source share the document's meshes; others are loaded. A problem with an assignment has
/// the file "--set".
[[nodiscard]] Result<Scene> scene_variant(const SceneDocument& document,
                                          const std::vector<Assignment>& assignments);

/// Many variants of one scene, each like scene_variant(): the scene's text is written and read once.
class SceneVariants {
  public:
    /// Precondition: `document` outlives this object.
    explicit SceneVariants(const SceneDocument& document);
    [[nodiscard]] Result<Scene> with(const std::vector<Assignment>& assignments) const;

  private:
    const SceneDocument& document_;
    Result<Json> json_;
};

// Converts a glTF file to a scene that can be drawn, and a scene to a glTF file.

struct GltfOpened {
    Scene scene;  // meshes loaded
    Warnings warnings;
};
/// Reads the file and adds missing parts of a picture: a camera that shows all objects, and two default
/// lights. A file written by Glint without lights stays dark. If lights are far too bright, because their
/// units are candela and lux, all are divided by one factor, which a warning states.
[[nodiscard]] Result<GltfOpened> open_gltf(const std::string& path);
/// Does the same with a file that has already been read.
[[nodiscard]] Result<GltfOpened> open_gltf(const Result<GltfFile>& file, const std::string& path);

/// A scene as a .glb file (unchecked_glb_of) that is known to open again. Otherwise returns a problem with
/// the pointer of the invalid value. Precondition: meshes are loaded.
[[nodiscard]] Result<GltfWritten> glb_of(const Scene& scene, const std::string& name);

/// JSON Schema, draft 2020-12, of the scene file: keys, types, ranges, words, defaults, generated from the
/// rows of models/fields/scene_fields.h. It accepts every valid scene. It cannot express conditions between
/// numbers (near < far, an area that is not zero; models/fields/scene_fields.h), so the reader may reject a
/// file that the schema accepts. Ends with a newline.
[[nodiscard]] std::string scene_schema();

// Internal to models/scene_file/.

/// The scene in a document after applying assignments. Fails with the problem of `json`, or like
/// parse_scene().
[[nodiscard]] Result<Scene> scene_of(const Result<Json>& json, const std::string& file,
                                     const std::vector<Assignment>& assignments);

/// True if an assignment sets the value at `pointer` or one that contains it.
[[nodiscard]] bool is_assigned(const std::string& pointer, const std::vector<Assignment>& assignments);

}  // namespace glint
