#pragma once
// Draws one triangle into one tile, using the edge functions of fill_rule.h.

#include "renderer/simd/double_lanes.h"
#include "renderer/visibility/fill_rule.h"

namespace glint::inline GLINT_ISA {

/// A corner on the grid, relative to the sample of the tile's first pixel.
struct TileCorner {
    int x, y;
    float inv_w;
};

/// A triangle ready for drawing, reordered to be clockwise on the screen (y down).
struct TileTriangle {
    TileCorner corner[3];
    long long area;      // doubled
    int x0, y0, x1, y1;  // the pixels of the tile whose samples its bounding box contains, inclusive
    int code;            // the value to write to its visible pixels (seen_code)
};

/// Positive if the corners are clockwise.
inline long long doubled_area(const TileTriangle& t) {
    const TileCorner *a = t.corner, *b = a + 1, *c = a + 2;
    return doubled_area<long long>(b->x - a->x, b->y - a->y, c->x - a->x, c->y - a->y);
}

inline void turn_over(TileTriangle& t) {
    const TileCorner second = t.corner[1];
    t.corner[1] = t.corner[2];
    t.corner[2] = second;
    t.area = -t.area;
}

/// inv_w over a triangle, linear on the screen: its value at the sample of pixel (x0, y0), and its steps
/// between adjacent pixels.
template <class D> struct DepthPlane { D value, step_x, step_y; };

/// A corner on the grid with its depth, and pixel (x0, y0) of the tile.
template <class D> struct PlaneCorner { D x, y, inv_w; };
template <class D> struct TilePixel { D x0, y0; };

/// `area`: doubled, positive if the corners are clockwise. Both windings give the same plane.
template <class D>
DepthPlane<D> depth_plane(const PlaneCorner<D> (&corner)[3], D area, const TilePixel<D>& pixel) {
    const auto& [a, b, c] = corner;
    const D x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
    const D q0 = a.inv_w, q1 = b.inv_w - q0, q2 = c.inv_w - q0, inverse = D(1) / area;
    const D per_x = (q1 * y2 - q2 * y1) * inverse, per_y = (q2 * x1 - q1 * x2) * inverse;
    const D value = q0 + per_x * (pixel.x0 * D(subpixels) - a.x) + per_y * (pixel.y0 * D(subpixels) - a.y);
    return {value, per_x * D(subpixels), per_y * D(subpixels)};
}

/// The depth and code that a triangle writes to its visible pixels.
struct TilePlane {
    DepthPlane<float> inv_w;
    TilePixel<int> from;  // pixel of `inv_w.value`
    int code;             // seen_code
};

inline TilePlane plane_of(const TileTriangle& t) {
    PlaneCorner<double> corner[3];
    for (int k = 0; k < 3; ++k)
        corner[k] = {static_cast<double>(t.corner[k].x), static_cast<double>(t.corner[k].y),
                     t.corner[k].inv_w};
    const DepthPlane<double> plane = depth_plane<double>(
        corner, static_cast<double>(t.area), {static_cast<double>(t.x0), static_cast<double>(t.y0)});
    return {
        {static_cast<float>(plane.value), static_cast<float>(plane.step_x), static_cast<float>(plane.step_y)},
        {t.x0, t.y0},
        t.code};
}

/// Patches of a tile (TilePixels), columns x0..x1 and rows y0..y1, and the three edges as functions of the
/// pixel (EdgeFunction): values at the first patch's first pixel, steps per pixel.
struct PatchEdges {
    int x0, y0, x1, y1;
    int value[3], step_x[3], step_y[3];
};

/// The columns and rows of the lanes' pixels within a patch. The first lane is pixel s.
template <Number F> IntOf<F> patch_column(int s) { return load_ints<IntOf<F>>(iota + s) & (patch_side - 1); }
template <Number F> IntOf<F> patch_row(int s) { return load_ints<IntOf<F>>(iota + s) >> patch_bits; }

/// The plane's inv_w at the pixel `column` to the right of and `row` below its first pixel; at least 0.
template <Number F> F inv_w_at(const DepthPlane<F>& plane, F column, F row) {
    return max0((plane.value + row * plane.step_y) + column * plane.step_x);
}
template <Number F> DepthPlane<F> broadcast(const DepthPlane<float>& plane) {
    return {F(plane.value), F(plane.step_x), F(plane.step_y)};
}

/// The depth test for the lanes of a patch: keeps the nearer of the stored surface and the triangle.
template <Number F>
void keep_nearer(MaskOf<F> inside, F inv_w, int triangle_code, float* nearest, std::int32_t* seen) {
    const F before = load<F>(nearest);
    const IntOf<F> shown = load_ints<IntOf<F>>(seen), code = broadcast<IntOf<F>>(triangle_code);
    const auto wins = mask_and(inside, is_in_front<F>(inv_w, code, before, shown));
    store(nearest, select(wins, inv_w, before));
    store_ints(seen, select(wins, code, shown));
}

/// Draws the triangle in the given patches.
template <Number F> void fill_patches(const PatchEdges& e, const TilePlane& plane, TilePixels& tile) {
    constexpr int width = NumberTraits<F>::width, steps = patch_pixels / width;
    using I = IntOf<F>;
    I of_row[3][steps];  // the edges at the lanes of the row's first patch
    for (int k = 0; k < 3; ++k)
        for (int s = 0; s < steps; ++s)
            of_row[k][s] =
                patch_column<F>(s * width) * e.step_x[k] + patch_row<F>(s * width) * e.step_y[k] + e.value[k];
    for (int py = e.y0;; ++py) {
        I edge[3][steps];
        for (int k = 0; k < 3; ++k)
            for (int s = 0; s < steps; ++s) edge[k][s] = of_row[k][s];
        for (int px = e.x0;; ++px) {
            const int first = (py * patches_a_row + px) * patch_pixels;
            for (int s = 0; s < steps; ++s) {
                const auto inside = not_negative(edge[0][s] | edge[1][s] | edge[2][s]);
                if (!any(inside)) continue;
                const F column = to_number(patch_column<F>(s * width) + (px * patch_side - plane.from.x0));
                const F row = to_number(patch_row<F>(s * width) + (py * patch_side - plane.from.y0));
                const F inv_w = inv_w_at<F>(broadcast<F>(plane.inv_w), column, row);
                const std::ptrdiff_t at = first + std::ptrdiff_t{s} * width;
                keep_nearer<F>(inside, inv_w, plane.code, tile.inv_w + at, tile.seen + at);
            }
            if (px == e.x1) break;  // before a step that may overflow 32 bits
            for (int k = 0; k < 3; ++k)
                for (int s = 0; s < steps; ++s) edge[k][s] = edge[k][s] + patch_side * e.step_x[k];
        }
        if (py == e.y1) break;
        for (int k = 0; k < 3; ++k)
            for (int s = 0; s < steps; ++s) of_row[k][s] = of_row[k][s] + patch_side * e.step_y[k];
    }
}

// Large triangles, whose edge functions may not fit 32 bits. They are computed in 64 bits and then moved to
// the tile.

using LongEdge = EdgeFunction<long long>;

inline LongEdge edge_from(const TileCorner& a, const TileCorner& b) {
    return edge_function<long long>(a.x, a.y, b.x, b.y);
}

enum class Fit { Outside, Fits, TooLarge };

/// Sets edge `k` of `out`, whose patches are given. Outside: none of the patches' pixels is inside the edge.
inline Fit fit_edge(const LongEdge& edge, PatchEdges& out, int k) {
    const int x0 = out.x0 * patch_side, x1 = out.x1 * patch_side + patch_side - 1;
    const int y0 = out.y0 * patch_side, y1 = out.y1 * patch_side + patch_side - 1;
    const long long low =
        edge.value + edge.step_x * (edge.step_x < 0 ? x1 : x0) + edge.step_y * (edge.step_y < 0 ? y1 : y0);
    const long long high =
        edge.value + edge.step_x * (edge.step_x < 0 ? x0 : x1) + edge.step_y * (edge.step_y < 0 ? y0 : y1);
    if (high < 0) return Fit::Outside;
    const bool all_inside = low >= 0;
    constexpr long long most = 0x7fffffff;
    if (!all_inside && (low < -most || high > most)) return Fit::TooLarge;
    const LongEdge taken = all_inside ? LongEdge{0, 0, 0} : edge;
    out.value[k] = static_cast<int>(taken.value + taken.step_x * x0 + taken.step_y * y0);
    out.step_x[k] = static_cast<int>(taken.step_x);
    out.step_y[k] = static_cast<int>(taken.step_y);
    return Fit::Fits;
}

/// Draws the patches x0..x1, y0..y1. If an edge does not fit, returns false without drawing.
template <Number F>
bool fill_long_edges(const TilePlane& plane, const LongEdge (&edges)[3], int x0, int y0, int x1, int y1,
                     TilePixels& tile) {
    PatchEdges patches{x0, y0, x1, y1, {}, {}, {}};
    for (int k = 0; k < 3; ++k) {
        const Fit fit = fit_edge(edges[k], patches, k);
        if (fit != Fit::Fits) return fit == Fit::Outside;
    }
    fill_patches<F>(patches, plane, tile);
    return true;
}

template <Number F> void fill_large_triangle(const TileTriangle& t, TilePixels& tile) {
    const LongEdge edges[3] = {edge_from(t.corner[0], t.corner[1]), edge_from(t.corner[1], t.corner[2]),
                               edge_from(t.corner[2], t.corner[0])};
    const TilePlane plane = plane_of(t);
    const int x0 = t.x0 / patch_side, y0 = t.y0 / patch_side;
    const int x1 = t.x1 / patch_side, y1 = t.y1 / patch_side;
    if (fill_long_edges<F>(plane, edges, x0, y0, x1, y1, tile)) return;
    for (int y = y0; y <= y1; ++y)  // more than 100,000 pixels long; a single patch always fits
        for (int x = x0; x <= x1; ++x) fill_long_edges<F>(plane, edges, x, y, x, y, tile);
}

}  // namespace glint::inline GLINT_ISA
