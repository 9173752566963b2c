#pragma once
// Draws one triangle into one tile, using the edge functions below.

#include "renderer/simd/double_lanes.h"
#include "renderer/simd/int_lanes.h"
#include "renderer/visibility/visibility_kernels.h"

namespace glint::inline GLINT_ISA {

// The only definition of the fill rule: area, edge functions and bounding box of a triangle whose corners are
// on the grid of 1/256 pixel, y down. All values are integers, so the rule is exact: a sample on an edge
// belongs to exactly one of the faces that share the edge (top-left rule). I: int, long long, or a vector of
// ints. Source: J. Pineda 1988.

/// -1 (all bits set) where a < 0, otherwise 0.
template <class I> I negative(I a) { return a >> 31; }
inline long long negative(long long a) { return a >> 63; }
/// 0 where a is -1, and -1 where a is 0.
template <class I> I inverted(I a) { return -1 - a; }

/// Twice the area of the triangle (0, 0), b, c; positive if it is clockwise on the screen.
template <class I> I doubled_area(I bx, I by, I cx, I cy) { return bx * cy - by * cx; }

/// An edge as a linear function of the pixel, non-negative inside. The exact value is divided by 256 and
/// rounded down. Between adjacent pixels the exact value changes by a multiple of 256, so the rounded part is
/// the same at every sample and never changes a sign.
template <class I> struct EdgeFunction {
    I value;           // at the sample of the pixel that is the corners' origin
    I step_x, step_y;  // change from one pixel to the next
};

/// The edge from a to b of a triangle that is clockwise on the screen. A sample exactly on a top or left edge
/// is inside. For other edges, the function is 1/256 smaller, so it is negative there.
template <class I> EdgeFunction<I> edge_function(I ax, I ay, I bx, I by) {
    const I dx = bx - ax, dy = by - ay;
    // y points down and the triangle is clockwise: a left edge goes up (dy < 0), a top edge goes right (dy =
    // 0, dx > 0).
    const I top_or_left = negative(dy) | (negative(0 - dx) & inverted(negative(0 - dy)));
    return {(dy * ax - dx * ay + inverted(top_or_left)) >> subpixel_bits, 0 - dy, dx};
}

/// The pixels whose samples a bounding box contains, inclusive. Empty if x1 < x0 or y1 < y0.
template <class I> struct SampleBox {
    I x0, y0, x1, y1;
    I small;  // -1: less than a tile wide and high
};

/// A triangle is small if its width and height are below this. The products of its corners' differences are
/// then below 2^29.
inline constexpr int small_side = tile_size * subpixels;

/// Pixel k's sample is at 256 k + `from` for the box's left and upper sides, and at 256 k + `to` for its
/// right and lower sides. The two differ if samples may be anywhere within a margin. Pixels are 0 to last_x
/// and 0 to last_y.
template <class I>
SampleBox<I> sample_box(const I (&x)[3], const I (&y)[3], int from, int to, int last_x, int last_y) {
    const I left = min(min(x[0], x[1]), x[2]), right = max(max(x[0], x[1]), x[2]);
    const I top = min(min(y[0], y[1]), y[2]), bottom = max(max(y[0], y[1]), y[2]);
    const int up = subpixels - 1 - from;  // the first sample at or after the side
    return {max((left + up) >> subpixel_bits, broadcast<I>(0)),
            max((top + up) >> subpixel_bits, broadcast<I>(0)),
            min((right - to) >> subpixel_bits, broadcast<I>(last_x)),
            min((bottom - to) >> subpixel_bits, broadcast<I>(last_y)),
            negative((right - left - small_side) & (bottom - top - small_side))};
}

/// Whether `code` at `depth` replaces `shown` at depth `before` (ScreenVertex) in a pixel. The nearer one
/// wins; at equal depth, the larger code. F: a float, or a vector of floats.
template <Number F> MaskOf<F> is_in_front(F depth, IntOf<F> code, F before, IntOf<F> shown) {
    return mask_or(depth > before, mask_and(depth >= before, code > shown));
}

/// A corner on the grid, relative to the sample of the tile's first pixel.
struct TileCorner {
    int x, y;
    float inv_w;
};

/// A triangle ready for drawing, reordered to be clockwise on the screen (y down).
struct TileTriangle {
    TileCorner corner[3];
    long long area;      // twice the area
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

// Large triangles, whose edge functions may not fit in 32 bits. They are computed in 64 bits and then moved
// to the tile.

using LongEdge = EdgeFunction<long long>;

inline LongEdge edge_from(const TileCorner& a, const TileCorner& b) {
    return edge_function<long long>(a.x, a.y, b.x, b.y);
}

enum class Fit { Outside, Fits, TooLarge };

/// Sets edge `k` of `out`, whose patches are given. Returns Outside if all pixels of the patches are outside
/// the edge.
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
    for (int y = y0; y <= y1; ++y)  // an edge is more than 100,000 pixels long; a single patch always fits
        for (int x = x0; x <= x1; ++x) fill_long_edges<F>(plane, edges, x, y, x, y, tile);
}

}  // namespace glint::inline GLINT_ISA
