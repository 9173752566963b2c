#pragma once
// Position and normal of every visible pixel.

#include "renderer/surface/surface.h"

namespace glint {

/// Fills points, point_object and point_count of a surface whose groups are found.
void interpolate_pixels(Surface& surface, const Geometry& geometry, const Visibility& visibility);

}  // namespace glint
