#pragma once
// The panels of the left column: the scene's list, and a panel for each kind of item. They may make an edit
// that would be invalid in a scene file; the caller reverts it (take_back_invalid() in ui/document/editor.h).

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "models/fields/choices.h"
#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "ui/document/job.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"
#include "ui/widgets/kept.h"

namespace glint {

struct MeshCheck;

/// Edits a light, whose JSON pointer is `pointer`: "/lights/1". Changing the kind or the space does not move
/// the light, as seen through `map` and `dome`.
void light_panel(Light& light, const std::string& pointer, const Camera& camera, const Dome& dome,
                 const ScreenMap& map);

/// Edits a material, whose JSON pointer is `pointer`: "/objects/0/material". Dims numbers that its reflection
/// model, which may be the scene's, does not use.
void material_panel(Material& material, const std::string& pointer, Reflection of_scene);

/// Copies a preset's ambient, diffuse, specular and shininess into the material; the other values do not
/// change.
void apply(const MaterialPreset& preset, Material& material);

/// Edits cool-to-warm tones, and strokes along silhouettes and creases. Dims numbers that have no effect.
void npr_panel(Npr& npr);

/// Also edits how light reaches points, and the global ambient light.
void shading_panel(Shading& shading, Transport& transport, glm::vec3& global_ambient);
void display_panel(Display& display);

/// `size` is the picture's size; with it, switching to a frustum keeps the visible region.
void camera_panel(Camera& camera, PictureSize size);
/// Shows the effective view angle or height if it is different because the picture is narrower than 16:9
/// (fitted()).
void note_fitted(const Camera& camera, PictureSize size);

/// Returns the same view in a different kind of projection: objects at the target's depth keep their size in
/// the picture.
[[nodiscard]] Projection as_projection(const Camera& camera, ProjectionKind kind, PictureSize size);

/// Requests from a panel to its caller, other than edits, and inputs from the caller.
struct ObjectRequests {
    bool browse_mesh = false;           // choose a mesh file
    GizmoMode gizmo = GizmoMode::Move;  // the gizmo in the picture; the panel may change it
    std::string about_mesh;             // a message shown next to the mesh's numbers
    MeshCheck* check = nullptr;         // the check of the mesh
};

/// Edits an object, whose JSON pointer is `pointer`: "/objects/0". A changed mesh source leaves Object::mesh
/// null: the caller loads it or reverts the edit.
void object_panel(Object& object, const std::string& pointer, Reflection reflection,
                  ObjectRequests& requests);

/// The state of the scene's list: the lights that the picture shows regardless of the scene's own switches
/// (one alone, or all but some), and the item being renamed.
struct LightFocus {
    int renamed = -1;                   // number_of() the item whose name is being typed in its row
    bool is_typed = false;              // whether its field has keyboard focus
    bool asks_setups = false;           // opens the menu of light setups
    int solo = -1;                      // index into Scene::lights; -1: none
    std::vector<int> muted;             // indices into Scene::lights
    int hovered = -1;                   // the row under the mouse
    std::vector<std::string> warnings;  // per light: why it may have less effect than expected; else empty
    std::size_t lights = 0;  // the number of lights at that time; if it has changed, the indices are invalid
    [[nodiscard]] bool is_on() const { return solo >= 0 || !muted.empty(); }
    [[nodiscard]] bool shows(int light) const {
        return solo >= 0 ? light == solo : std::find(muted.begin(), muted.end(), light) == muted.end();
    }
    void toggle_solo(int light);
    void toggle_muted(int light);
};

/// Draws the list: edits the scene (adds, deletes, switches) and the selection. Sets `browse_mesh` to request
/// a mesh file for a new object.
void scene_panel(Scene& scene, Selection& selection, LightFocus& focus, bool& browse_mesh);

// Measures how much of an object's highlight survives its shading: flat and Gouraud shading lose a highlight
// that covers no vertex. Lecture: Gouraud shading misses highlights.

/// Returns the object's brightest specular light in a picture of that size, relative to Phong shading: about
/// 1 if triangles are small. It may be slightly above 1 if a vertex is closer to the peak than any pixel
/// centre. Returns nullopt without a highlight. `object`: index in Scene::objects.
[[nodiscard]] std::optional<double> highlight_share(const Scene& scene, std::size_t object, PictureSize size);

/// The result of highlight_share(), cached until the scene has changed and settled.
struct HighlightShareState {
    struct Key {
        Scene scene;
        std::size_t object = 0;
        bool operator==(const Key&) const = default;
    };
    Kept<Key, std::optional<double>> share;
};

/// Returns the share as a note next to a mesh; empty if lighting is computed per pixel, or if there is no
/// highlight.
[[nodiscard]] std::string highlight_words(HighlightShareState& state, const Scene& scene, std::size_t object,
                                          PictureSize size);

// Lists the defects of an object's mesh, where they are, and how other programs would draw them.

struct MeshCheck {
    MeshPtr mesh;                  // the mesh that is being or was checked
    std::optional<MeshInfo> info;  // info about `mesh`, once it is known
    JobPtr<MeshInfo> job, ending;  // computes `info`; a cancelled job
    bool is_wanted = false;  // the selected object's panel needs it: it is open, or the mesh is from a file
    int hovered = -1, shown = -1;  // findings whose positions the picture shows
};

/// Draws the findings about the object's mesh, with a button for each repair that the scene can store.
void mesh_check_rows(MeshCheck& check, Object& object);

}  // namespace glint
