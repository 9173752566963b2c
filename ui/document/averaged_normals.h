#pragma once
// Notifies the user when a mesh without normals is drawn with averaged normals, which make its creases look
// smooth.

#include "models/scene/scene.h"

namespace glint {

struct UiState;

/// Whether the object's mesh has no normals of its own, and its facet normals are averaged across every edge.
[[nodiscard]] bool smooths_every_edge(const Object& object);

/// Adds a notification if smooths_every_edge() is true for the object.
void say_averaged(UiState& state, const Object& object);

/// If the open document is a single mesh, selects it, because its panel checks the mesh and can keep creases.
/// Reports averaged normals.
void tell_averaged_normals(UiState& state);

}  // namespace glint
