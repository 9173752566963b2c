#pragma once
// Part of stage 3: the steps that fill a Surface (multisample.cpp, interpolate_pixels.cpp, lit_points.cpp).

#include "renderer/surface/surface.h"

namespace glint {

// Several samples a pixel: which faces each pixel shows, with what share of its samples.

/// Fills groups, group_samples and pixel_count from all planes of the visibility, in reading order.
void find_sampled_groups(Surface& surface, const Geometry& geometry, const Visibility& visibility);

// Position and normal of every visible pixel.

/// Fills points, point_object and point_count of a surface whose groups are found.
void interpolate_pixels(Surface& surface, const Geometry& geometry, const Visibility& visibility);

// Gouraud and flat shading light only the corners and faces that are seen, each once.

/// Fills points, point_object, sources and the refs of every group. Precondition: the groups are found.
void collect_lit_points(Surface& surface, const Geometry& geometry, const Visibility& visibility);

}  // namespace glint
