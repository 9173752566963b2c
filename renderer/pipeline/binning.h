#pragma once
// Which triangles may touch which tile of the screen.

#include "renderer/pipeline/geometry.h"

namespace glint {

/// Pixels x0..x1, y0..y1, inclusive; empty when x1 < x0 or y1 < y0.
struct PixelBox {
    int x0 = 0, y0 = 0, x1 = -1, y1 = -1;
    [[nodiscard]] bool empty() const { return x1 < x0 || y1 < y0; }
};

/// The pixels within `limits` whose centres lie in the bounding box of a triangle, made larger by `margin`
/// (1/256 pixel) on every side.
[[nodiscard]] PixelBox pixels_of(const std::array<ScreenVertex, 3>& corner, const PixelBox& limits,
                                 int margin = 0);

/// Twice the area on the grid; positive when the corners run clockwise as seen (y runs down).
[[nodiscard]] inline std::int64_t doubled_area(const std::array<ScreenVertex, 3>& c) {
    return std::int64_t{c[1].x - c[0].x} * (c[2].y - c[0].y) -
           std::int64_t{c[1].y - c[0].y} * (c[2].x - c[0].x);
}

/// Fills tiles_x, tiles_y, tile_first and tile_triangles: for each tile the numbers of the triangles (and
/// clipped pieces) whose bounding box meets it, in rising order. Triangles out of view or without area are
/// left out.
void sort_into_tiles(Geometry& geometry);

}  // namespace glint
