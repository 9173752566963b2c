#pragma once
// The only definition of the fill rule: area, edge functions and bounding box of a triangle whose corners are
// on the grid of 1/256 pixel, y down. All values are integers, so the rule is exact: a sample on an edge
// belongs to exactly one of the faces that share the edge (top-left rule). I: int, long long, or a vector of
// ints. Source: J. Pineda 1988.

#include "renderer/simd/int_lanes.h"
#include "renderer/visibility/visibility_kernels.h"

namespace glint::inline GLINT_ISA {

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
    I step_x, step_y;  // to the next pixel
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

}  // namespace glint::inline GLINT_ISA
