#pragma once
// Computes weights of a triangle's corners at a pixel directly from their clip coordinates. This needs no
// clipping and no division by a w that may be 0 or negative, so a triangle that crosses the eye's plane is
// not a special case. Lecture: "Gouraud Shading Artifacts" (perspective); M. Olano, T. Greer 1997 for the
// homogeneous edge functions.

#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

/// A corner's x, y and w in clip coordinates: its screen position times w, and its distance in front of the
/// eye (1 for an orthographic camera).
template <Number F> struct ClipCorner { F x{}, y{}, w{}; };

/// A position on the screen in NDC: x and y from -1 (left, bottom) to 1 (right, top).
template <Number F> struct ScreenPoint { F x{}, y{}; };

/// Converts a position in pixels, y down, in a picture of width x height: the inverse of to_pixel.
template <Number F> ScreenPoint<F> to_ndc(F x, F y, F width, F height) {
    return {F(2) * x / width - F(1), F(1) - F(2) * y / height};
}

/// Returns numbers proportional to the weights of three corners where the ray through `at` intersects their
/// plane. They are non-negative inside the triangle, seen from either side.
template <Number F>
Vec3<F> edge_functions(ClipCorner<F> a, ClipCorner<F> b, ClipCorner<F> c, ScreenPoint<F> at) {
    // Subtracts first, so that a small triangle far away keeps its precision.
    const F ax = a.x - at.x * a.w, ay = a.y - at.y * a.w;
    const F bx = b.x - at.x * b.w, by = b.y - at.y * b.w;
    const F cx = c.x - at.x * c.w, cy = c.y - at.y * c.w;
    const Vec3<F> e{bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx};
    return select<F>(e.x + e.y + e.z < F(0), -e, e);  // for a triangle seen from behind
}

/// Perspective-correct weights (for points, colours or normals in space) of three corners where the ray
/// through `at` intersects their plane; they sum to 1. A sample slightly outside the triangle, due to the
/// rasterizer's grid of 1/256 pixel, gets the weights of the nearest position inside. A triangle seen exactly
/// edge-on gets 1/3 each.
template <Number F>
Vec3<F> perspective_weights(ClipCorner<F> a, ClipCorner<F> b, ClipCorner<F> c, ScreenPoint<F> at) {
    Vec3<F> e = edge_functions(a, b, c, at);
    e = {max0(e.x), max0(e.y), max0(e.z)};
    const F inverse = inverse_or_zero(e.x + e.y + e.z), third = F(1.0f / 3);
    return select<F>(inverse > F(0), inverse * e, Vec3<F>{third, third, third});
}

/// Converts perspective-correct weights to weights that are linear on the screen. Precondition: all w > 0. If
/// products exceed the range of floats, returns the weights unchanged. Source: perspective-correct
/// interpolation, a = sum(b_i a_i / w_i) / sum(b_i / w_i) with screen weights b, as in Heckbert and Moreton
/// 1991, solved for b.
template <Number F> Vec3<F> screen_weights(Vec3<F> perspective, F wa, F wb, F wc) {
    const Vec3<F> e{perspective.x * wa, perspective.y * wb, perspective.z * wc};
    const F inverse = inverse_or_zero(e.x + e.y + e.z);
    return select<F>(inverse > F(0), inverse * e, perspective);
}

template <Number F> Vec3<F> blend(Vec3<F> weights, Vec3<F> a, Vec3<F> b, Vec3<F> c) {
    return weights.x * a + weights.y * b + weights.z * c;
}

/// Adds one corner to a weighted sum. Skips a corner of weight 0, so that it does not change any bit of the
/// sum.
template <Number F> Vec3<F> add_weighted(Vec3<F> sum, F weight, Vec3<F> value) {
    return select<F>(weight > F(0), sum + weight * value, sum);
}

}  // namespace glint::inline GLINT_ISA
