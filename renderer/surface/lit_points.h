#pragma once
// Gouraud and flat shading light only the corners and faces that are seen, each once.

#include "renderer/surface/surface.h"

namespace glint {

/// Fills points, point_object, sources and the refs of every group. Precondition: the groups are found.
void collect_lit_points(Surface& surface, const Geometry& geometry, const Visibility& visibility);

}  // namespace glint
