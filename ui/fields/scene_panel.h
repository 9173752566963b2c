#pragma once
// What is in the scene: camera, lights, objects, and how they are shaded and shown.

#include <optional>

#include "ui/document/scene_edit.h"

namespace glint {

struct SceneWishes {
    bool browse_mesh = false;  // add an object from a mesh file
};

/// The list. Edits the scene (adds, deletes, switches) and the selection; says whether the scene changed.
[[nodiscard]] bool scene_panel(Scene& scene, Selection& selection, SceneWishes& wishes);

}  // namespace glint
