#pragma once
// Triangles to samples, tile by tile (kernels/fill_triangle.h).

#include "renderer/visibility/visibility.h"

namespace glint {

/// Fills `seen`, `covered` and `tile_drawn` of `visibility` (already sized) from all tiles, in parallel.
void rasterize_tiles(const Geometry& geometry, Visibility& visibility);

}  // namespace glint
