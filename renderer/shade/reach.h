#pragma once
// Which groups of points a light certainly leaves dark: asked of a group's bounds, so that its points need
// not be read.

#include "renderer/lighting/light_source.h"

namespace glint::inline GLINT_ISA {

/// A ball around places and a ball around their normals, camera coordinates; normals are unit or zero.
template <Number F> struct Reach {
    Vec3<F> center;
    F radius{};
    Vec3<F> normal;
    F spread{};
};

/// True where n.l < 0 for every place p and normal n of the bounds, rounding included; NaN is never certain.
/// For a light at q, with d = q - center: n.(q - p) <= normal.d + spread |d| + radius.
template <Number F> MaskOf<F> certainly_behind(const LightAt<F>& light, const Reach<F>& bounds) {
    const F room(1e-5f);       // far more than rounding takes, relative to each part
    const F shortest(1e-18f);  // whose square is lost below the smallest numbers
    const Vec3<F> d = vector_to_light(light, bounds.center);
    const F away = is_place(light) ? bounds.radius + room * bounds.radius : F(0);
    const F most = (bounds.spread + room) * (length(d) + shortest) + away;
    return dot(bounds.normal, d) + most < F(0);
}

}  // namespace glint::inline GLINT_ISA
