#pragma once
// The vertex transform, in doubles: from object to camera to clip coordinates, then the viewport transform
// onto the rasterizer's grid. Also transforms normals to camera coordinates. D is one number (double) or a
// vector of numbers (Doubles).

#include "renderer/geometry/geometry_kernels.h"
#include "renderer/simd/double_lanes.h"
#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

template <Number D> struct Point4 { D x, y, z, w; };

template <Number D> Point4<D> transformed(const Matrix4& m, const Point4<D>& p) {
    const auto row = [&](int r) {
        return (D(m.column[0][r]) * p.x + D(m.column[1][r]) * p.y) +
               (D(m.column[2][r]) * p.z + D(m.column[3][r]) * p.w);
    };
    return {row(0), row(1), row(2), row(3)};
}

/// The OutsideBits of a vertex as two sums: the bits of the view's sides, and the bits that require clipping.
/// `c`: the vertex in clip coordinates.
template <Number D> struct Outside { D sides, cut; };
template <Number D> Outside<D> outside_of(const Point4<D>& c) {
    const auto bit = [](auto where, OutsideBits b) { return select(where, D(static_cast<double>(b)), D(0)); };
    const auto one = [](auto where) { return select(where, D(1), D(0)); };
    const D sides = bit(c.x < -c.w, OutsideLeft) + bit(c.x > c.w, OutsideRight) +
                    bit(c.y < -c.w, OutsideBottom) + bit(c.y > c.w, OutsideTop);
    const D g = D(guard_band) * c.w;  // NaN counts as outside
    const D within =
        one(c.x >= -g) * one(c.x <= g) * one(c.y >= -g) * one(c.y <= g) * one(c.w >= D(min_float_w));
    return {sides, bit(c.z < -c.w, OutsideNear) + bit(c.z > c.w, OutsideFar) +
                       (D(1) - within) * D(static_cast<double>(OutsideGuard))};
}

/// A point on the rasterizer's grid, in its units (1/256 pixel), y down; and its depth.
template <Number D> struct GridPoint { D x, y, inv_w; };

/// Rounds to the nearest integer, halves away from zero. |a| < 2^31.
template <Number D> D nearest(D a) {
    const D towards_zero = truncated(a), rest = a - towards_zero;  // exact
    return towards_zero + select(rest >= D(0.5), D(1), D(0)) - select(rest <= D(-0.5), D(1), D(0));
}
/// A position in pixels: x to the right, y down, (0, 0) at the picture's upper left corner. Precondition: w
/// != 0. Source: OpenGL 2.1, section 2.11.1.
template <Number D> struct PixelPoint { D x, y; };
template <Number D> PixelPoint<D> to_pixel(const Viewport& viewport, const Point4<D>& clip) {
    return {(clip.x / clip.w + D(1)) * D(0.5) * D(viewport.width),
            (D(1) - clip.y / clip.w) * D(0.5) * D(viewport.height)};
}
/// The depth used by the depth test; larger is nearer, linear on the screen. 1/w in perspective, and (1 -
/// z_ndc)/2 in orthographic projection, where w is always 1.
template <Number D> D inv_w_of(const Viewport& viewport, const Point4<D>& clip) {
    return viewport.orthographic ? D(0.5) * (D(1) - clip.z / clip.w) : D(1) / clip.w;
}
template <Number D> GridPoint<D> grid_point(const Viewport& viewport, const Point4<D>& clip) {
    const PixelPoint<D> at = to_pixel(viewport, clip);
    return {at.x * D(subpixels), at.y * D(subpixels), inv_w_of(viewport, clip)};
}

/// Transforms a normal to camera coordinates; the result is not normalized.
template <Number D> Vec3<D> to_camera(const Matrix3& m, Vec3<D> n) {
    const auto row = [&](int r) {
        return D(m.column[0][r]) * n.x + D(m.column[1][r]) * n.y + D(m.column[2][r]) * n.z;
    };
    return {row(0), row(1), row(2)};
}

/// v / |v| with correctly rounded divisions. (0, 0, 0) is unchanged.
template <Number D> Vec3<D> unit_or_zero(Vec3<D> v) {
    const D length = square_root(dot(v, v));
    const auto any_length = length > D(0);
    const D divisor = select(any_length, length, D(1));
    return select<D>(any_length, Vec3<D>{v.x / divisor, v.y / divisor, v.z / divisor}, Vec3<D>{});
}

}  // namespace glint::inline GLINT_ISA
