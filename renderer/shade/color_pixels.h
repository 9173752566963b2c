#pragma once
// Part of stage 4: every pixel's colour from the lit points, its bytes, and the strokes over them.

#include "renderer/shade/lighting.h"

namespace glint {

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
