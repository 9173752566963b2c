#pragma once
// Triangles to samples. Vertices lie on a grid of 1/256 pixel and edge functions are integers, so the fill
// rule is exact: a sample on an edge belongs to exactly one of the faces that share it (top-left rule).

#include "renderer/pipeline/visibility.h"

namespace glint {

/// Fills keys and back of `visibility` (already sized) from all tiles, in parallel.
void rasterize_tiles(const Geometry& geometry, Visibility& visibility);

}  // namespace glint
