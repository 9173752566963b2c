#pragma once
// A light in the equation's form: camera coordinates, colours times intensity.
// Lecture: "Light Sources", "Light Source Falloff".

#include "renderer/lighting/light_job.h"
#include "renderer/simd/pow.h"
#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

template <Number F> struct LightAt {
    Vec3<F> xyz;  // w = 0: unit direction towards the light; w = 1: its position
    F w{};        // 0 or 1, the same in all lanes
    // For mistakes: the position transformed as a direction, and as given in the scene.
    Vec3<F> as_direction, as_given;
    Vec3<F> ambient, diffuse, specular;    // linear RGB times intensity
    F constant{1}, linear{}, quadratic{};  // falloff 1 / (constant + linear r + quadratic r^2)
    Vec3<F> axis;          // unit vector: the direction of a spot, or the normal of an area light's patch
    F cos_cutoff{-1};      // of a spot
    Exponent<F> exponent;  // of a spot
    F soft_edge{};         // 1 / (cos inner - cos cutoff) of a spot with a soft edge; else 0
    F patch{};             // of an area light's sample: area / (pi * samples)
    bool has_falloff = false, has_cone = false, is_patch = false;
    bool has_soft_edge = false;
    bool has_ambient = true;  // false: its ambient colour is 0
};

/// False for a directional light.
template <Number F> bool is_positional(const LightAt<F>& light) { return lane(light.w, 0) > 0; }

/// From p to the light, not normalized; for a directional light, the unit direction itself.
template <Number F> Vec3<F> vector_to_light(const LightAt<F>& light, Vec3<F> p) {
    return is_positional(light) ? light.xyz - p : light.xyz;
}

/// constant + linear r + quadratic r^2. D: any number type.
template <class D> D falloff_polynomial(D constant, D linear, D quadratic, D r) {
    return constant + r * (linear + r * quadratic);
}

/// 1 / (constant + linear r + quadratic r^2) at the distance r >= 0, at most max_factor; 0 instead of a
/// division by zero. Lecture: "Light Source Falloff" (its a, b, c are quadratic, linear, constant).
template <Number F> F falloff(const LightAt<F>& light, F r) {
    const F divisor = falloff_polynomial(light.constant, light.linear, light.quadratic, r);
    return min(inverse_or_zero(divisor), F(max_factor));
}

/// |v| times the cosine of the angle between the spot's axis and the ray from the light to the point. v
/// points from the surface point to the light.
template <Number F> F along_axis(const LightAt<F>& light, Vec3<F> v) { return -dot(v, light.axis); }

/// cos(angle)^exponent between the spot's axis and the ray to the point, 0 outside the cone; the edge is
/// inside, as in may_be_inside(). A soft edge multiplies it by ((cos angle - cos cutoff) / (cos inner - cos
/// cutoff))^2, at most 1. l: the unit vector towards the light. Source: OpenGL 2.1, section 2.14.1;
/// KHR_lights_punctual, "Inner and Outer Cone Angles"; lecture: "point + direction + cutoff angle".
template <Number F> F spot_factor(const LightAt<F>& light, Vec3<F> l) {
    const F cos_angle = along_axis(light, l);
    const auto inside = cos_angle >= light.cos_cutoff;
    if (!any(inside)) return F(0);
    F factor = power(min(cos_angle, F(1)), light.exponent);
    if (light.has_soft_edge) {
        const F share = min((cos_angle - light.cos_cutoff) * light.soft_edge, F(1));
        factor = factor * share * share;
    }
    return select(inside, factor, F(0));
}

/// False if all lanes are certainly outside the cone. Compares signed squares of cosines times |to_light|^2,
/// so that no square root is taken, with a margin for rounding.
template <Number F> bool may_be_inside(const LightAt<F>& light, Vec3<F> to_light) {
    const F along = along_axis(light, to_light);
    const F least = light.cos_cutoff * abs(light.cos_cutoff) - F(1e-5f);
    return any(along * abs(along) >= least * dot(to_light, to_light));
}

/// The factor that replaces falloff for one sample of an area light: A |cos theta'| / (pi n^2 r^2), theta' at
/// the emitter; 0 at r = 0, at most max_factor. With all samples it tends to Lambert's polygon formula.
template <Number F> F patch_factor(const LightAt<F>& light, Vec3<F> l, F r) {
    return min(light.patch * abs(dot(l, light.axis)) * inverse_or_zero(r * r), F(max_factor));
}

}  // namespace glint::inline GLINT_ISA
