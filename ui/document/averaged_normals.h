#pragma once
// A mesh without normals of its own gets averaged ones, and its creases look smooth: where that is said.

#include "models/scene/scene.h"

namespace glint {

struct UiState;

/// Whether the object's mesh has no normals of its own and its facets' are averaged across every edge.
[[nodiscard]] bool smooths_every_edge(const Object& object);

/// A notification, where it does.
void say_averaged(UiState& state, const Object& object);

/// Where the open document is a mesh that does: says so, and selects the object, whose panel keeps its
/// creases.
void tell_averaged_normals(UiState& state);

}  // namespace glint
