#pragma once
// Back-face test for a group of points: whether all of them certainly face away from a light. Uses the
// group's bounding sphere and normal cone, without reading its points.

#include "renderer/lighting/light_job.h"

namespace glint::inline GLINT_ISA {

/// A bounding sphere of the points' positions and one of their normals, in camera coordinates. Normals are
/// unit vectors or zero.
template <Number F> struct GroupBounds {
    Vec3<F> center;
    F radius{};
    Vec3<F> normal;
    F spread{};
};

/// True if n.l < 0 for every position p and normal n within the bounds, including rounding errors; false for
/// NaN. For a light at q, with d = q - center: n.(q - p) <= normal.d + spread |d| + radius.
template <Number F> MaskOf<F> certainly_behind(const LightAt<F>& light, const GroupBounds<F>& bounds) {
    const F room(1e-5f);       // much larger than rounding errors, relative to each part
    const F shortest(1e-18f);  // its square underflows
    const Vec3<F> d = vector_to_light(light, bounds.center);
    const F away = is_positional(light) ? bounds.radius + room * bounds.radius : F(0);
    const F most = (bounds.spread + room) * (length(d) + shortest) + away;
    return dot(bounds.normal, d) + most < F(0);
}

}  // namespace glint::inline GLINT_ISA
