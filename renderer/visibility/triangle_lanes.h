#pragma once
// Sets up several triangles at once: boxes, areas and edges, using the formulas of fill_triangle.h. The
// results are the same as for single triangles if they fit in 32 bits.

#include "renderer/simd/transpose.h"
#include "renderer/visibility/fill_triangle.h"

namespace glint::inline GLINT_ISA {

/// The corners of several triangles on the grid, relative to the sample of the tile's first pixel.
template <Number F> struct CornerLanes {
    IntOf<F> number;  // the triangle's number
    IntOf<F> x[3], y[3];
    F inv_w[3];
};

/// N triangles ready for drawing into one tile. Flags are -1 (true) or 0.
template <unsigned N> struct TriangleLanes {
    int number[N];
    int x[3][N], y[3][N];
    float inv_w[3][N];
    int x0[N], y0[N], x1[N], y1[N];  // as in TileTriangle
    int empty[N];                    // -1: the box contains no sample of the tile
    int small[N];                    // -1: the members below are valid; 0: they may not fit
    int area[N];
    int value[3][N], step_x[3][N], step_y[3][N];  // as in PatchEdges, of the triangle reordered clockwise
    DepthPlane<float[N]> plane;                   // at pixel (x0, y0)
};

/// Edge `k`, from a to b.
template <class I, unsigned N>
void store_edge(TriangleLanes<N>& out, int k, I ax, I ay, I bx, I by, I patch_x, I patch_y) {
    const EdgeFunction<I> edge = edge_function(ax, ay, bx, by);
    store_ints(out.value[k], edge.value + edge.step_x * patch_x + edge.step_y * patch_y);
    store_ints(out.step_x[k], edge.step_x);
    store_ints(out.step_y[k], edge.step_y);
}

template <Number F> void store_planes(TriangleLanes<NumberTraits<F>::width>& out) {
    using D = typename HalfAsMany<F>::Type;
    for (int i = 0; i < NumberTraits<F>::width; i += HalfAsMany<F>::width) {
        PlaneCorner<D> corner[3];
        for (int k = 0; k < 3; ++k)
            corner[k] = {widened<D>(out.x[k] + i), widened<D>(out.y[k] + i), widened<D>(out.inv_w[k] + i)};
        const DepthPlane<D> plane = depth_plane<D>(corner, widened<D>(out.area + i),
                                                   {widened<D>(out.x0 + i), widened<D>(out.y0 + i)});
        store_narrowed(out.plane.value + i, plane.value);
        store_narrowed(out.plane.step_x + i, plane.step_x);
        store_narrowed(out.plane.step_y + i, plane.step_y);
    }
}

template <Number F> void make_ready(const CornerLanes<F>& in, TriangleLanes<NumberTraits<F>::width>& out) {
    using I = IntOf<F>;
    const I(&x)[3] = in.x;
    const I(&y)[3] = in.y;
    const auto [x0, y0, x1, y1, small] = sample_box(x, y, 0, 0, tile_size - 1, tile_size - 1);
    I sx[3], sy[3];  // zero if the products below would not fit
    for (int k = 0; k < 3; ++k) {
        sx[k] = small & x[k];
        sy[k] = small & y[k];
    }
    const I area = doubled_area<I>(sx[1] - sx[0], sy[1] - sy[0], sx[2] - sx[0], sy[2] - sy[0]);
    store_ints(out.number, in.number);
    for (int k = 0; k < 3; ++k) {
        store_ints(out.x[k], x[k]);
        store_ints(out.y[k], y[k]);
        store(out.inv_w[k], in.inv_w[k]);
    }
    store_ints(out.x0, x0);
    store_ints(out.y0, y0);
    store_ints(out.x1, x1);
    store_ints(out.y1, y1);
    store_ints(out.empty, negative((x1 - x0) | (y1 - y0)));
    store_ints(out.small, small);
    store_ints(out.area, area);
    const auto clockwise = not_negative(area);
    const I bx = select(clockwise, sx[1], sx[2]), by = select(clockwise, sy[1], sy[2]);
    const I cx = select(clockwise, sx[2], sx[1]), cy = select(clockwise, sy[2], sy[1]);
    const I patch_x = x0 & ~(patch_side - 1), patch_y = y0 & ~(patch_side - 1);
    store_edge(out, 0, sx[0], sy[0], bx, by, patch_x, patch_y);
    store_edge(out, 1, bx, by, cx, cy, patch_x, patch_y);
    store_edge(out, 2, cx, cy, sx[0], sy[0], patch_x, patch_y);
    store_planes<F>(out);
}

template <unsigned N> TileTriangle triangle_of_lane(const TriangleLanes<N>& lanes, unsigned i) {
    TileTriangle t;
    for (int k = 0; k < 3; ++k) t.corner[k] = {lanes.x[k][i], lanes.y[k][i], lanes.inv_w[k][i]};
    t.area = lanes.area[i];
    t.x0 = lanes.x0[i];
    t.y0 = lanes.y0[i];
    t.x1 = lanes.x1[i];
    t.y1 = lanes.y1[i];
    t.code = 0;
    return t;
}

template <unsigned N> TilePlane plane_of_lane(const TriangleLanes<N>& lanes, unsigned i, int code) {
    return {{lanes.plane.value[i], lanes.plane.step_x[i], lanes.plane.step_y[i]},
            {lanes.x0[i], lanes.y0[i]},
            code};
}

template <unsigned N> PatchEdges edges_of_lane(const TriangleLanes<N>& lanes, unsigned i) {
    PatchEdges e{lanes.x0[i] / patch_side,
                 lanes.y0[i] / patch_side,
                 lanes.x1[i] / patch_side,
                 lanes.y1[i] / patch_side,
                 {},
                 {},
                 {}};
    for (int k = 0; k < 3; ++k) {
        e.value[k] = lanes.value[k][i];
        e.step_x[k] = lanes.step_x[k][i];
        e.step_y[k] = lanes.step_y[k][i];
    }
    return e;
}

// Triangles of a few pixels, one per lane. All lanes step through their boxes together and list the covered
// pixels, which are then depth-tested against the tile one by one.

/// Triangles whose box has a side longer than this, in pixels, are drawn faster individually, patch by patch.
inline constexpr int tiny_side = 6;

/// The pixels of N triangles' boxes, one per triangle and step, with their depths, and the list of covered
/// pixels.
template <unsigned N> struct Fragments {
    static constexpr unsigned most = N * tiny_side * tiny_side;
    int at[most];  // indices in the tile (TilePixels)
    float inv_w[most];
    int code[N];  // seen_code of each triangle
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

/// Draws the lanes of `chosen` (-1; others 0), whose boxes are tiny. `code`: the value of their pixels.
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
