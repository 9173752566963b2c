#pragma once
// Part of stage 4: the steps of update_lighting().

#include "renderer/shade/lighting.h"

namespace glint {

// Part of stage 4: the equation over the surface's points.

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

// Part of stage 4: every pixel's colour from the lit points, its bytes, and the strokes over them.

/// Fills the picture with the background and the strokes over it.
void clear_picture(Lighting& lighting, PictureSize size, const Strokes& strokes, const DisplayJob& display);

/// Gives only those pixels the background again that showed a surface in the last picture (Lighting::covered)
/// and show none now. Preconditions: no strokes are drawn; size, background and display are as they were.
void uncover(Lighting& lighting, const Visibility& visibility, const DisplayJob& display);

/// Colours the pixels that show a surface. Preconditions: the picture was cleared since its background,
/// strokes or visibility changed, and point_colors are up to date.
void color_pixels(Lighting& lighting, const Surface& surface, const Strokes& strokes,
                  const DisplayJob& display);

}  // namespace glint
