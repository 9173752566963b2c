#pragma once
// The back-facing test of a group of points: whether a light certainly leaves all of them dark. Uses the
// group's bounding sphere and normal cone, so that its points need not be read.

#include "renderer/lighting/light_source.h"

namespace glint::inline GLINT_ISA {

/// A sphere around the points' positions and one around their normals, camera coordinates; normals are unit
/// or zero.
template <Number F> struct GroupBounds {
    Vec3<F> center;
    F radius{};
    Vec3<F> normal;
    F spread{};
};

/// True if n.l < 0 for every position p and normal n of the bounds, rounding included; NaN is never certain.
/// For a light at q, with d = q - center: n.(q - p) <= normal.d + spread |d| + radius.
template <Number F> MaskOf<F> certainly_behind(const LightAt<F>& light, const GroupBounds<F>& bounds) {
    const F room(1e-5f);       // far more than rounding errors, relative to each part
    const F shortest(1e-18f);  // its square underflows
    const Vec3<F> d = vector_to_light(light, bounds.center);
    const F away = is_positional(light) ? bounds.radius + room * bounds.radius : F(0);
    const F most = (bounds.spread + room) * (length(d) + shortest) + away;
    return dot(bounds.normal, d) + most < F(0);
}

}  // namespace glint::inline GLINT_ISA
