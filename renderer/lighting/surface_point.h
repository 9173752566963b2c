#pragma once
// A surface point to be lit, and its material.

#include "renderer/simd/pow.h"
#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

/// A point to be lit: position, normal and direction to the eye. Camera coordinates, scene units. n and v are
/// unit vectors (n may be zero if it is undefined); v points towards the eye.
template <Number F> struct PointAt {
    Vec3<F> p, n, v;
    F n_dot_v{};
    PointAt() = default;
    PointAt(Vec3<F> position, Vec3<F> normal, Vec3<F> to_eye)
        : p(position), n(normal), v(to_eye), n_dot_v(dot(normal, to_eye)) {}
};

/// The material, which is the same at all points of an object.
template <Number F> struct MaterialAt {
    Vec3<F> k_a, k_d, k_s;  // linear RGB
    Exponent<F> shininess;
    F min_cosine_squared{};  // no highlight unless c |c| is above this; below it, cos^shininess would be
                             // invisible
    F roughness{};           // 0 to 1
    Vec3<F> f0;              // reflectance at normal incidence
};

/// The response of a reflection model to one light: the factors of the diffuse and specular terms.
template <Number F> struct Response {
    F diffuse{};
    Vec3<F> specular;  // S, per channel; the caller ignores it if the light is behind the surface
};

/// The vectors and cosines used by the models. l, r, h are unit vectors in camera coordinates. The compiler
/// omits those that a model does not use.
template <Number F> struct Directions {
    Vec3<F> l, r, h;  // towards the light; l mirrored about n; halfway between l and v (0 when l = -v)
    F n_dot_l{}, r_dot_v{}, n_dot_h{}, l_dot_v{};        // not clamped
    F n_dot_unnormalized_h{}, unnormalized_h_squared{};  // n.h and |h|^2 before normalizing h
};

/// The vector from a point to a light, not normalized (for a directional light, the unit direction), and its
/// product with n.
template <Number F> struct LightVector {
    Vec3<F> xyz;
    F n_dot{};
};

/// The values that depend only on the distance to a light.
template <Number F> struct Attenuation {
    F distance{1}, inverse{1};  // scene units, and 1 / distance; 1 for a directional light
    F falloff{1};               // 1 for a light without falloff
};

/// The vectors and cosines for l = light_vector / distance. Lecture: "Calculating R Vector", "Blinn-Phong
/// Model". r.v = (2 n (n.l) - l).v = 2 (n.l)(n.v) - l.v. h has the direction of l + v, as does light_vector +
/// distance v, which needs no division.
template <Number F>
Directions<F> directions_for(const LightVector<F>& light_vector, const Attenuation<F>& attenuation,
                             const PointAt<F>& at) {
    const F distance = attenuation.distance, inverse = attenuation.inverse;
    Directions<F> d;
    d.l = inverse * light_vector.xyz;
    d.n_dot_l = inverse * light_vector.n_dot;
    const F along_v = dot(light_vector.xyz, at.v);
    d.l_dot_v = inverse * along_v;
    d.r = (d.n_dot_l + d.n_dot_l) * at.n - d.l;
    d.r_dot_v = inverse * ((light_vector.n_dot + light_vector.n_dot) * at.n_dot_v - along_v);
    const Vec3<F> unnormalized_h = light_vector.xyz + distance * at.v;
    d.n_dot_unnormalized_h = light_vector.n_dot + distance * at.n_dot_v;
    d.unnormalized_h_squared = dot(unnormalized_h, unnormalized_h);
    const F shorten = inverse_or_zero(square_root(d.unnormalized_h_squared));
    d.h = shorten * unnormalized_h;
    d.n_dot_h = shorten * d.n_dot_unnormalized_h;
    return d;
}

/// The vectors and cosines for a unit l.
template <Number F> Directions<F> directions_for(Vec3<F> l, const PointAt<F>& at) {
    return directions_for(LightVector<F>{l, dot(at.n, l)}, Attenuation<F>{}, at);
}

/// c^shininess for the cosine c = scaled / length, of any sign, computed as (c^2)^(shininess / 2) to avoid
/// the square root. 0 unless c^2, with the sign of c, is above `min_cosine_squared`; in much of a typical
/// picture it is not.
template <Number F> F highlight(F scaled, F length_squared, const MaterialAt<F>& m) {
    const F squared = max(length_squared, F(smallest_normal));
    const auto seen = scaled * abs(scaled) > m.min_cosine_squared * squared;
    if (!any(seen)) return F(0);
    // If h is almost lost to rounding, the quotient is arbitrary.
    const F cosine_squared = min(max(scaled * scaled / squared, m.min_cosine_squared), F(1));
    return select(seen, power_of_root(cosine_squared, m.shininess), F(0));
}
template <Number F> F highlight(F cosine, const MaterialAt<F>& m) { return highlight(cosine, F(1), m); }

// Rounds each light's contribution, so the contributions of many lights can be added exactly and in any
// order. While one light is dragged, the sum of all others can then be cached
// (renderer/shade/lighting.h), and the picture is bit-identical to adding all lights again.

/// Returns the `magic` argument of rounded(): 1.5 * 2^23 * grid. grid: a power of two, or 0.
inline float rounding_magic(float grid) { return grid * 12582912.0f; }

/// Rounds each component to the nearest multiple of `grid` by adding and subtracting `magic`; floats near
/// `magic` are `grid` apart. Precondition: |c| <= 2^22 grid. Multiples of grid add exactly, in any order, as
/// long as the sum stays within 2^24 grid. magic = 0: no rounding.
template <Number F> Vec3<F> rounded(Vec3<F> c, float magic) {
    return {(c.x + F(magic)) - F(magic), (c.y + F(magic)) - F(magic), (c.z + F(magic)) - F(magic)};
}

}  // namespace glint::inline GLINT_ISA
