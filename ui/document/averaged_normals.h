#pragma once
// Notifies the user if a mesh without normals gets averaged ones, which make its creases look smooth.

#include "models/scene/scene.h"

namespace glint {

struct UiState;

/// Whether the object's mesh has no normals and its facets' are averaged across every edge.
[[nodiscard]] bool smooths_every_edge(const Object& object);

/// Adds a notification if smooths_every_edge() is true for the object.
void say_averaged(UiState& state, const Object& object);

/// If the open document is one mesh, selects it: its panel checks it and can keep creases. Reports averaged
/// normals.
void tell_averaged_normals(UiState& state);

}  // namespace glint
