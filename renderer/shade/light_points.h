#pragma once
// Part of stage 4: the equation over the surface's points.

#include "renderer/shade/lighting.h"

namespace glint {

/// Lights `count` blocks of points from `first` on, each with its object's job; `partial_sums`: sums to which
/// the jobs' lights are added, one for each of these blocks, or null.
void light_blocks(const std::vector<LightJob>& jobs, const Surface& surface, std::size_t first,
                  std::size_t count, const ColorBlock* partial_sums, ColorBlock* colors);

/// Lights `count` blocks of points from `first` on with all lights, or with the moving one over the kept sum
/// of the others.
void light_points(const Lighting& lighting, const Surface& surface, std::size_t first, std::size_t count,
                  ColorBlock* colors);

/// Under Corners and Faces: brings point_colors up to date; Faces: point_rgba too.
void color_points(Lighting& lighting, const Surface& surface, const Geometry& geometry,
                  const DisplayJob& display);

}  // namespace glint
