#pragma once
// Triangles of a few pixels, one a lane: all step through their boxes together, and what they cover is
// listed, then held against the tile pixel by pixel.

#include "renderer/visibility/triangle_lanes.h"

namespace glint::inline GLINT_ISA {

/// Boxes of more pixels than this a side are faster alone, patch by patch.
inline constexpr int tiny_side = 6;

/// What N triangles have at the pixels of their boxes, step by step; and which of that they cover.
template <unsigned N> struct Fragments {
    static constexpr unsigned most = N * tiny_side * tiny_side;
    int at[most];  // where in the tile (TilePixels)
    float inv_w[most];
    int code[N];  // what is seen of each triangle
    int covered[most + N];
    unsigned covered_count = 0;
};

template <unsigned N> void keep_nearer(const Fragments<N>& fragments, TilePixels& tile) {
    for (unsigned i = 0; i < fragments.covered_count; ++i) {
        const auto which = static_cast<unsigned>(fragments.covered[i]);
        const int at = fragments.at[which], code = fragments.code[which % N];
        const float inv_w = fragments.inv_w[which], before = tile.inv_w[at];
        if (is_in_front<float>(inv_w, code, before, tile.seen[at])) {
            tile.inv_w[at] = inv_w;
            tile.seen[at] = code;
        }
    }
}

/// Draws the lanes of `chosen` (-1; others 0), whose boxes are tiny; `code`: what their pixels get.
template <Number F>
void fill_tiny(const TriangleLanes<NumberTraits<F>::width>& lanes, IntOf<F> chosen, IntOf<F> code,
               TilePixels& tile) {
    constexpr unsigned width = NumberTraits<F>::width;
    using I = IntOf<F>;
    const I x0 = load_ints<I>(lanes.x0), y0 = load_ints<I>(lanes.y0);
    const I right = chosen & (load_ints<I>(lanes.x1) - x0), below = chosen & (load_ints<I>(lanes.y1) - y0);
    const int columns = reduce_max(right), rows = reduce_max(below);
    const DepthPlane<F> plane{load<F>(lanes.plane.value), load<F>(lanes.plane.step_x),
                              load<F>(lanes.plane.step_y)};
    I of_row[3], step_x[3], step_y[3];
    for (int k = 0; k < 3; ++k) {
        step_x[k] = load_ints<I>(lanes.step_x[k]);
        step_y[k] = load_ints<I>(lanes.step_y[k]);
        of_row[k] = load_ints<I>(lanes.value[k]) + (x0 & (patch_side - 1)) * step_x[k] +
                    (y0 & (patch_side - 1)) * step_y[k];
    }
    Fragments<width> found;
    store_ints(found.code, code);
    int step = 0;
    for (int row = 0; row <= rows; ++row) {
        I edge[3] = {of_row[0], of_row[1], of_row[2]};
        const I y = y0 + row, row_ends = (below - row) | inverted(chosen);
        const I patch_row =
            (y >> patch_bits) * (patches_a_row * patch_pixels) + (y & (patch_side - 1)) * patch_side;
        for (int column = 0; column <= columns; ++column) {
            const auto inside = not_negative(edge[0] | edge[1] | edge[2] | row_ends | (right - column));
            const I x = x0 + column,
                    at = patch_row + (x >> patch_bits) * patch_pixels + (x & (patch_side - 1));
            const F inv_w = inv_w_at<F>(plane, F(static_cast<float>(column)), F(static_cast<float>(row)));
            store_ints(found.at + step, at);
            store(found.inv_w + step, inv_w);
            found.covered_count +=
                compress_store(inside, load_ints<I>(iota) + step, found.covered + found.covered_count);
            step += static_cast<int>(width);
            for (int k = 0; k < 3; ++k) edge[k] = edge[k] + step_x[k];
        }
        for (int k = 0; k < 3; ++k) of_row[k] = of_row[k] + step_y[k];
    }
    keep_nearer(found, tile);
}

}  // namespace glint::inline GLINT_ISA
