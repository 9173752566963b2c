#pragma once
// Which triangles may touch which tile of the screen.

#include "renderer/pipeline/geometry.h"

namespace glint {

/// Fills `chunks`, from all objects' vertices on the screen: for each triangle that is not out of view the
/// tiles that its bounding box meets, or that it has to be clipped.
void find_boxes(Geometry& geometry);

/// Fills tile_first and tile_triangles from `chunks` and `clipped`: for each tile the numbers of the
/// triangles (and clipped pieces) whose bounding box meets it, in rising order.
void sort_into_tiles(Geometry& geometry);

}  // namespace glint
