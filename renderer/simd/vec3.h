#pragma once
// Three numbers of any width: a vector or a linear RGB colour. GLM's vec3 is not used because its dot and
// normalize support only scalars.

#include "renderer/simd/lanes.h"

namespace glint::inline GLINT_ISA {

template <Number F> struct Vec3 { F x{}, y{}, z{}; };

template <Number F> Vec3<F> operator+(Vec3<F> a, Vec3<F> b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <Number F> Vec3<F> operator-(Vec3<F> a, Vec3<F> b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <Number F> Vec3<F> operator-(Vec3<F> a) { return {-a.x, -a.y, -a.z}; }
template <Number F> Vec3<F> operator*(F s, Vec3<F> a) { return {s * a.x, s * a.y, s * a.z}; }
/// Multiplies component by component: a light's colour times a material's (red light on green is black).
template <Number F> Vec3<F> operator*(Vec3<F> a, Vec3<F> b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

template <Number F> F dot(Vec3<F> a, Vec3<F> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <Number F> Vec3<F> cross(Vec3<F> a, Vec3<F> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <Number F> F length(Vec3<F> a) { return square_root(dot(a, a)); }

/// a / |a|. (0, 0, 0) is unchanged: a missing normal gives black, never NaN.
template <Number F> Vec3<F> unit(Vec3<F> a) { return inverse_or_zero(length(a)) * a; }

/// A unit vector perpendicular to the unit vector a. Scalars only (float or double).
template <class D> Vec3<D> any_perpendicular(Vec3<D> a) {
    const Vec3<D> helper = abs(a.x) < D(0.6) ? Vec3<D>{D(1), D(0), D(0)} : Vec3<D>{D(0), D(1), D(0)};
    return unit(helper - dot(helper, a) * a);
}

template <Number F> Vec3<F> select(MaskOf<F> m, Vec3<F> a, Vec3<F> b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

/// Broadcasts anything with members x, y, z to all lanes.
template <Number F, class V> Vec3<F> broadcast(const V& a) { return {F(a.x), F(a.y), F(a.z)}; }

}  // namespace glint::inline GLINT_ISA
