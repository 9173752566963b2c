#pragma once
// The panels of the left column: the list of the scene, and a panel for each kind of item in it. Each edits
// its value and says whether it did.

#include <optional>
#include <string>

#include "models/fields/choices.h"
#include "models/scene/material.h"
#include "models/scene/scene.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/handles/light_place.h"
#include "ui/picture/handles/object_drag.h"

namespace glint {

/// Edits a light, whose JSON pointer is `pointer`: "/lights/1". When kind or space change, the light stays
/// where it is, as seen in `map` and `dome`.
[[nodiscard]] bool light_panel(Light& light, const std::string& pointer, const Camera& camera,
                               const Dome& dome, const ScreenMap& map);

/// Edits a material, whose JSON pointer is `pointer`: "/objects/0/material". Numbers that `reflection` does
/// not use are dimmed.
[[nodiscard]] bool material_panel(Material& material, const std::string& pointer, Reflection reflection);

/// Gives the material a preset's ambient, diffuse, specular and shininess; the rest stays.
void apply(const MaterialPreset& preset, Material& material);

/// Cool-to-warm tones, and strokes along silhouettes and creases. Numbers without effect are dimmed.
bool npr_panel(Npr& npr);

[[nodiscard]] bool shading_panel(Shading& shading, glm::vec3& global_ambient);
[[nodiscard]] bool display_panel(Display& display);

/// `size` of the picture: a frustum chosen anew sees what it saw.
[[nodiscard]] bool camera_panel(Camera& camera, PictureSize size);
/// Says what a picture narrower than 16:9 is drawn with where that is not what the camera says (fitted()).
void note_fitted(const Camera& camera, PictureSize size);

/// Shows the same view through another kind of projection: what is at the target's depth keeps its size in
/// the picture.
[[nodiscard]] Projection as_projection(const Camera& camera, ProjectionKind kind, PictureSize size);

/// What a panel asks of its caller beside an edit, and what it is told.
struct ObjectRequests {
    bool browse_mesh = false;           // choose a mesh file
    GizmoMode gizmo = GizmoMode::Move;  // in the picture: what it is, and what it shall be
    std::string about_mesh;             // to be said beside the mesh's numbers
};

/// Edits an object, whose JSON pointer is `pointer`: "/objects/0". A changed mesh source leaves Object::mesh
/// null: the caller loads it, or takes the edit back.
[[nodiscard]] bool object_panel(Object& object, const std::string& pointer, Reflection reflection,
                                ObjectRequests& requests);

/// The list: edits the scene (adds, deletes, switches) and the selection; says whether the scene changed.
/// Sets `browse_mesh` when an object is to be added from a mesh file.
[[nodiscard]] bool scene_panel(Scene& scene, Selection& selection, bool& browse_mesh);

}  // namespace glint
