#pragma once
// One light's numbers.

#include <optional>
#include <string>

#include "models/fields/choices.h"
#include "models/scene/material.h"
#include "models/scene/scene.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/handles/light_place.h"
#include "ui/picture/handles/object_drag.h"

namespace glint {

/// Edits the light and says whether it did. `pointer`: its place in the scene file, "/lights/1". Kind and
/// space change so that the light stays where it is, as seen in `map` and `dome`.
[[nodiscard]] bool light_panel(Light& light, const std::string& pointer, const Camera& camera,
                               const Dome& dome, const ScreenMap& map);

// What a surface does with light.

/// Edits the material and says whether it did. `pointer`: "/objects/0/material". Numbers that `reflection`
/// does not use are dimmed.
[[nodiscard]] bool material_panel(Material& material, const std::string& pointer, Reflection reflection);

/// Gives the material a preset's ambient, diffuse, specular and shininess; the rest stays.
void apply(const MaterialPreset& preset, Material& material);

// Shading that does not imitate a photograph: cool-to-warm tones, and strokes along silhouettes and creases.

/// Edits `npr`; says whether it did. Numbers without effect are dimmed.
bool npr_panel(Npr& npr);

// How the scene is shaded, and how it is shown.

/// Each edits its value and says whether it did.
[[nodiscard]] bool shading_panel(Shading& shading, glm::vec3& global_ambient);
[[nodiscard]] bool display_panel(Display& display);

// The camera's numbers.

/// Edits the camera and says whether it did. `size` of the picture: a frustum chosen anew sees what it saw.
[[nodiscard]] bool camera_panel(Camera& camera, PictureSize size);

/// Shows the same view through another kind of projection: what is at the target's depth keeps its size in
/// the picture.
[[nodiscard]] Projection as_projection(const Camera& camera, ProjectionKind kind, PictureSize size);

// One object: its mesh, where it stands, its normals, its material.

/// What a panel asks of its caller beside an edit.
struct ObjectRequests {
    bool browse_mesh = false;           // choose a mesh file
    GizmoMode gizmo = GizmoMode::Move;  // in the picture: what it is, and what it shall be
};

/// Edits the object and says whether it did; `pointer`: "/objects/0". A changed mesh source leaves
/// Object::mesh null: the caller loads it, or takes the edit back.
[[nodiscard]] bool object_panel(Object& object, const std::string& pointer, Reflection reflection,
                                ObjectRequests& requests);

// What is in the scene: camera, lights, objects, and how they are shaded and shown.

struct SceneRequests {
    bool browse_mesh = false;  // add an object from a mesh file
};

/// The list. Edits the scene (adds, deletes, switches) and the selection; says whether the scene changed.
[[nodiscard]] bool scene_panel(Scene& scene, Selection& selection, SceneRequests& requests);

}  // namespace glint
