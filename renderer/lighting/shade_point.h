#pragma once
// Converts plain numbers to the equation's types, and sums all lights at one point (or 16).

#include "renderer/lighting/illuminate.h"
#include "renderer/lighting/light_job.h"
#include "renderer/lighting/reflection.h"

namespace glint::inline GLINT_ISA {

template <Number F> LightAt<F> light_at(const LightSource& s) {
    LightAt<F> light;
    light.xyz = broadcast<F>(s.xyz);
    light.w = F(s.w);
    light.as_direction = broadcast<F>(s.as_direction);
    light.as_given = broadcast<F>(s.as_given);
    light.ambient = broadcast<F>(s.ambient);
    light.diffuse = broadcast<F>(s.diffuse);
    light.specular = broadcast<F>(s.specular);
    light.constant = F(s.constant);
    light.linear = F(s.linear);
    light.quadratic = F(s.quadratic);
    light.axis = broadcast<F>(s.axis);
    light.cos_cutoff = F(s.cos_cutoff);
    light.exponent = F(s.exponent);
    light.soft_edge = F(s.soft_edge);
    light.has_soft_edge = s.soft_edge > 0;
    light.patch = F(s.patch);
    light.has_falloff = s.has_falloff;
    light.has_cone = s.has_cone;
    light.is_patch = s.is_patch;
    light.has_ambient = s.ambient.x != 0 || s.ambient.y != 0 || s.ambient.z != 0;
    return light;
}

template <Number F> MaterialAt<F> material_at(const SurfaceMaterial& s) {
    return {broadcast<F>(s.k_a),     broadcast<F>(s.k_d), broadcast<F>(s.k_s), F(s.shininess),
            F(s.min_cosine_squared), F(s.roughness),      broadcast<F>(s.f0)};
}

/// A point with its direction to the eye: from p to the eye, or (0, 0, 1) for a viewer at infinity. The
/// kernels name `any_mistake` themselves: even a branch that is never taken would cost them registers.
template <Number F> PointAt<F> seen_from_eye(const LightJob& job, bool any_mistake, Vec3<F> p, Vec3<F> n) {
    if (any_mistake) return mistakenly_seen(job, p, n);
    const Vec3<F> toward_z{F(0), F(0), F(1)};
    return PointAt<F>(p, n, job.infinite_viewer ? toward_z : unit(broadcast<F>(job.eye) - p));
}
template <Number F> PointAt<F> seen_from_eye(const LightJob& job, Vec3<F> p, Vec3<F> n) {
    return seen_from_eye(job, job.any_mistake, p, n);
}

/// The terms that need no light: emission + k_a I_a.
template <Number F> Vec3<F> unlit(const SurfaceMaterial& material, const Terms& terms) {
    Vec3<F> sum;
    if (terms.emission) sum = broadcast<F>(material.emission);
    if (terms.ambient) sum = sum + broadcast<F>(material.global_ambient);
    return sum;
}

/// The part of a job that is the same for every point. The kernels pass model and mistakes as constants, so
/// the compiler knows them.
inline Equation equation_of(const LightJob& job, Reflection model, bool any_mistake) {
    return {model, job.terms, any_mistake ? &job.mistakes : nullptr, job.power_table,
            rounding_magic(job.grid)};
}
inline Equation equation_of(const LightJob& job) { return equation_of(job, job.model, job.any_mistake); }

// The picture (lighting_kernels_isa.cpp, many points at once), the explanation and the tests all build the
// sum over the lights from these three steps. They agree to the last bit, because no compiler contracts a * b
// + c (cmake/options.cmake, -ffp-contract=off).

/// The start of the sum: emission and global ambient light, or the tone that replaces them.
template <Number F> Vec3<F> begin_sum(const LightJob& job, const PointAt<F>& at) {
    if (job.tone.on) return cool_to_warm(job.tone, broadcast<F>(job.material.k_d), at).color;
    return rounded(unlit<F>(job.material, job.terms), rounding_magic(job.grid));
}

/// The same with light from other surfaces (Arrivals::bounced), which replaces global ambient light if
/// job.bounced.
template <Number F> Vec3<F> begin_sum(const LightJob& job, const PointAt<F>& at, Vec3<F> bounced) {
    if (!job.bounced || job.tone.on) return begin_sum(job, at);
    Vec3<F> sum;
    if (job.terms.emission) sum = broadcast<F>(job.material.emission);
    if (job.terms.ambient) sum = sum + broadcast<F>(job.material.k_d) * bounced;
    return rounded(sum, rounding_magic(job.grid));
}

/// Adds one light's contribution to the sum, and returns it. A light for which may_add() is false contributes
/// 0 and may be skipped.
template <Number F>
Vec3<F> add_light(Vec3<F>& sum, const Equation& equation, const LightAt<F>& light,
                  const LightTerms<F>& terms) {
    const Vec3<F> share = share_of(equation, light, terms);
    sum = sum + share;
    return share;
}

/// The colour of the point: linear RGB before exposure.
template <Number F> Vec3<F> end_sum(const LightJob& job, Vec3<F> sum) {
    return job.clamp ? clamped(sum) : sum;
}

/// The entire equation at one point. Calls `reaches(i)` for each light i of the job, which returns 0 if
/// something blocks the light and 1 otherwise, and `visit(i, terms, share)`. `bounced`: as for begin_sum().
template <Number F, class Reaches, class Visit>
Vec3<F> shade_point(const LightJob& job, const PointAt<F>& at, Vec3<F> bounced, const Reaches& reaches,
                    const Visit& visit) {
    const Equation equation = equation_of(job);
    const MaterialAt<F> material = material_at<F>(job.material);
    Vec3<F> sum = begin_sum(job, at, bounced);
    for (std::size_t i = 0; i < job.light_count; ++i) {
        const LightAt<F> light = light_at<F>(job.lights[i]);
        LightTerms<F> terms = illuminate(equation, light, material, at);
        remove_blocked(terms, reaches(i));
        visit(i, terms, add_light(sum, equation, light, terms));
    }
    return end_sum(job, sum);
}
/// The same without blocked lights and without light from other surfaces.
template <Number F> Vec3<F> shade_point(const LightJob& job, const PointAt<F>& at) {
    return shade_point(
        job, at, Vec3<F>{}, [](std::size_t) { return F(1); },
        [](std::size_t, const LightTerms<F>&, const Vec3<F>&) {});
}

}  // namespace glint::inline GLINT_ISA
