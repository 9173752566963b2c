#pragma once
// Part of stage 4: every pixel's colour from the lit points, its bytes, and the strokes over them.

#include "renderer/shade/lighting.h"

namespace glint {

/// Everything the background's colour with the strokes over it, as it is displayed.
void clear_picture(Lighting& lighting, PictureSize size, const Strokes& strokes, const DisplayJob& display);

/// The same, where only those pixels differ from it that showed a surface (Lighting::covered), no strokes are
/// drawn, and size and background are as they were.
void uncover(Lighting& lighting, const Visibility& visibility, const DisplayJob& display);

/// The pixels that show a surface. Preconditions: the picture was cleared since its background, strokes or
/// visibility changed, and point_colors are up to date.
void color_pixels(Lighting& lighting, const Surface& surface, const Strokes& strokes,
                  const DisplayJob& display);

}  // namespace glint
