#pragma once
// One object: its mesh, where it stands, its normals, its material.

#include <string>

#include "models/scene/scene.h"
#include "ui/picture/handles/object_drag.h"

namespace glint {

/// What a panel asks of its caller beside an edit.
struct ObjectWishes {
    bool browse_mesh = false;           // choose a mesh file
    GizmoMode gizmo = GizmoMode::Move;  // in the picture: what it is, and what it shall be
};

/// Edits the object and says whether it did; `pointer`: "/objects/0". A changed mesh source leaves
/// Object::mesh null: the caller loads it, or takes the edit back.
[[nodiscard]] bool object_panel(Object& object, const std::string& pointer, Reflection reflection,
                                ObjectWishes& wishes);

}  // namespace glint
