#pragma once
// Stage 2. Finds the triangle visible at each sample: clips and culls triangles, sorts them into tiles, and
// draws them by an exact integer fill rule. The nearest triangle wins; ties go to the lower object and then
// the lower face. Inputs: the geometry and `cull`.

#include <cstdint>
#include <vector>

#include "renderer/simd/pixel_vector.h"
#include "renderer/visibility/binning.h"

namespace glint {

struct Visibility {
    Cull cull = Cull::None;
    std::vector<std::uint8_t> hidden;  // #triangles, 1: not drawn; empty: draws all
    PictureSize size{0, 0};            // picture size of `seen`, `covered` and `tile_drawn`
    int samples = 1;  // per pixel: 1, 2, 4 or 8; each sample has its own plane of width x height
    TileLists tiles;
    std::vector<DrawnObject> objects;
    std::size_t plane = 0;            // width x height
    PixelVector<std::uint32_t> seen;  // `samples` planes: seen_code of the nearest triangle; 0: none
    // With one sample per pixel: which pixels in each group of 16 in a row show a triangle, groups_a_row per
    // row.
    std::vector<std::uint16_t> covered;
    std::size_t groups_a_row = 0;
    std::vector<std::uint8_t> tile_drawn;  // 0: the tile is empty, including in `seen` and `covered`

    [[nodiscard]] std::uint32_t triangle_at(std::size_t pixel) const {
        return seen[pixel] ? triangle_of_code(seen[pixel]) : no_triangle;
    }
    /// Whether the visible triangle is clockwise on the screen.
    [[nodiscard]] bool back_at(std::size_t pixel) const { return seen[pixel] && back_of_code(seen[pixel]); }
};

/// The position of sample `which` of `samples` in its pixel, in 1/256 pixel from the centre. A single sample
/// is at the centre. Several samples use the standard rotated grids, so that nearly horizontal and vertical
/// edges get as many steps as there are samples.
struct SampleOffset {
    int x = 0, y = 0;
};
[[nodiscard]] SampleOffset sample_offset(int samples, int which);

/// Runs the stage again if the geometry, `cull`, `samples` or `hidden` has changed; returns whether it did.
/// `hidden`: as in Visibility.
bool update_visibility(Visibility& kept, const Geometry& geometry, Cull cull, int samples,
                       bool geometry_redone, const std::vector<std::uint8_t>& hidden = {});

}  // namespace glint
