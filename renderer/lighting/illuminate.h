#pragma once
// The lighting equation, written once for all number types. Camera coordinates, linear RGB. Lecture: "Phong
// Lighting Model".
//
//   I = k_e + k_a I_a + sum over lights of falloff spot (k_a A + k_d D <n.l> + k_s S spec)
//
// Every step is a named member, so the picture adds the same values that the inspector prints.

#include "models/scene/shading.h"
#include "renderer/lighting/equation_mistakes.h"
#include "renderer/lighting/light_job.h"
#include "renderer/lighting/reflection.h"
#include "renderer/lighting/surface_point.h"

namespace glint::inline GLINT_ISA {

/// All terms of one light at one point.
template <Number F> struct LightTerms {
    Directions<F> directions;
    F distance{};                        // scene units; undefined for a directional light
    F falloff{}, spot{};                 // 1 if the light has none
    Response<F> response;                // its specular is 0 if n.l <= 0
    Vec3<F> ambient, diffuse, specular;  // light that reaches the eye; 0 if the term is switched off
};

/// The equation to evaluate: model, terms and rules; the same for all points of a picture.
struct Equation {
    Reflection model = Reflection::Phong;
    Terms terms;
    const Mistakes* mistakes = nullptr;  // null: no mistakes and no table
    int power_table = 0;                 // Shading::power_table
    float rounding = 0;                  // each contribution c becomes rounded(c, rounding); 0: not rounded
};

/// A light's colours times the material's: linear RGB, the light that reaches the eye if every factor is 1.
template <Number F> struct LightColors { Vec3<F> ambient, diffuse, specular; };
template <Number F> LightColors<F> colors_on(const MaterialAt<F>& m, const LightAt<F>& light) {
    return {m.k_a * light.ambient, m.k_d * light.diffuse, m.k_s * light.specular};
}

/// The vector from the point to the light in camera coordinates (scene units; for a directional light, the
/// unit direction) and its product with n. Not normalized, so lights behind the surface need no square root.
template <Number F> LightVector<F> light_vector(const LightAt<F>& light, const PointAt<F>& at) {
    const Vec3<F> xyz = vector_to_light(light, at.p);
    return {xyz, dot(at.n, xyz)};
}

/// The distance to the light, its inverse and the falloff, 1 / (c + b r + a r^2). A light at the point itself
/// has distance 0 and inverse 0; a directional light has 1 for all three.
template <Number F> Attenuation<F> attenuation(const LightAt<F>& light, const LightVector<F>& light_vector) {
    Attenuation<F> a;
    if (is_positional(light)) {
        a.distance = length(light_vector.xyz);
        a.inverse = inverse_or_zero(a.distance);
    }
    if (light.has_falloff) a.falloff = falloff(light, a.distance);
    return a;
}

/// The equation for one light and one point. `colors`: colors_on(m, light), which is the same at all points;
/// `light_vector` and `attenuation`: the results of the functions with these names at this point. Degenerate
/// input: a light at the point has l = 0, so only its ambient term is left, as for n = 0; l = -v gives h = 0.
/// No term overflows or is NaN (max_factor in light_job.h), except with the mistakes that cause NaN.
/// `with_mistakes`: must be true unless equation.mistakes is null. If false, the code of the mistakes is not
/// compiled, which saves registers in the kernels.
template <bool with_mistakes = true, Number F>
LightTerms<F> illuminate(const Equation& equation, const LightAt<F>& light, const MaterialAt<F>& m,
                         const LightColors<F>& colors, const LightVector<F>& light_vector,
                         const Attenuation<F>& attenuation, const PointAt<F>& at) {
    LightTerms<F> t;
    LightVector<F> towards = light_vector;
    Attenuation<F> reach = attenuation;
    if constexpr (with_mistakes)
        if (equation.mistakes) apply_vector_mistakes(*equation.mistakes, light, at, towards, reach);
    t.distance = attenuation.distance;
    t.directions = directions_for(towards, reach, at);
    t.falloff = reach.falloff;
    if (light.is_patch) t.falloff = patch_factor(light, t.directions.l, t.distance);
    t.spot = light.has_cone ? spot_factor(light, t.directions.l) : F(1);
    [[maybe_unused]] const Mistakes* const wrong = with_mistakes ? equation.mistakes : nullptr;
    if constexpr (with_mistakes) {
        if (wrong) apply_light_mistakes(*wrong, light, t.distance, t.directions.l, t.falloff, t.spot);
        if (wrong) apply_direction_mistakes(*wrong, equation.model, t.directions, towards, at);
    }
    const F reaching = t.falloff * t.spot;  // scales all three terms, as in OpenGL 2.1, section 2.14.1

    const auto lit_side = t.directions.n_dot_l > F(0);
    t.response = respond(equation.model, t.directions, m, at);
    // No highlight from behind; may_add() and certainly_behind() skip lights under the same condition.
    t.response.specular = select<F>(lit_side, t.response.specular, Vec3<F>{});
    if constexpr (with_mistakes)
        if (wrong)
            apply_response_mistakes(*wrong, equation.power_table, equation.model, t.response, t.directions, m,
                                    at);

    if (equation.terms.ambient && light.has_ambient) t.ambient = reaching * colors.ambient;
    if (wrong && wrong->ambient_not_attenuated && equation.terms.ambient && light.has_ambient)
        t.ambient = colors.ambient;
    if (wrong && wrong->ambient_per_light_added_twice) t.ambient = F(2) * t.ambient;
    F diffuse = reaching * t.response.diffuse;
    Vec3<F> specular = reaching * t.response.specular;
    if (wrong) diffuse = held(diffuse, F(max_factor));
    if (wrong || !info_of(equation.model).is_bounded) {
        const F most(max_factor);
        specular = {held(specular.x, most), held(specular.y, most), held(specular.z, most)};
    }
    if (equation.terms.diffuse) t.diffuse = diffuse * colors.diffuse;
    if (equation.terms.specular) t.specular = specular * colors.specular;
    if constexpr (with_mistakes)
        if (wrong)
            apply_undefined_powers(*wrong, equation.model, t.directions, m, t.response.specular,
                                   equation.terms.specular ? &t.specular : nullptr);
    if constexpr (with_mistakes)
        if (wrong && wrong->zero_normal_is_nan) apply_undefined_normal(at, t.ambient, t.diffuse, t.specular);
    return t;
}
template <Number F>
LightTerms<F> illuminate(const Equation& equation, const LightAt<F>& light, const MaterialAt<F>& m,
                         const PointAt<F>& at) {
    const LightVector<F> towards = light_vector(light, at);
    return illuminate(equation, light, m, colors_on(m, light), towards, attenuation(light, towards), at);
}

/// Removes the terms where something blocks the light: where `reached` is 0 rather than 1.
template <Number F> void remove_blocked(LightTerms<F>& t, F reached) {
    const auto lit = reached > F(0);
    t.ambient = select<F>(lit, t.ambient, Vec3<F>{});
    t.diffuse = select<F>(lit, t.diffuse, Vec3<F>{});
    t.specular = select<F>(lit, t.specular, Vec3<F>{});
}

/// False if the light adds nothing in any lane: it is behind the surface and has no ambient term, or its cone
/// points elsewhere. Checked first, because this holds for half of a typical picture.
template <Number F>
bool may_add(const Equation& equation, const LightAt<F>& light, const LightVector<F>& light_vector) {
    if (equation.mistakes) return true;
    if (light.has_cone && !may_be_inside(light, light_vector.xyz)) return false;
    return (equation.terms.ambient && light.has_ambient) || any(light_vector.n_dot > F(0));
}

/// Each component clamped to 0 to 1; NaN gives 0.
template <Number F> Vec3<F> clamped(Vec3<F> c) {
    return {min(max0(c.x), F(1)), min(max0(c.y), F(1)), min(max0(c.z), F(1))};
}

/// One light's contribution to the sum: linear RGB, with its terms added in the picture's order.
template <Number F>
Vec3<F> share_of(const Equation& equation, const LightAt<F>& light, const LightTerms<F>& t) {
    Vec3<F> share = t.diffuse + t.specular;
    if (light.has_ambient) share = share + t.ambient;
    if (equation.mistakes && equation.mistakes->clamp_each_light) share = clamped(share);
    return rounded(share, equation.rounding);  // so that a partial sum can be kept: surface_point.h
}

// Converts plain numbers to the equation's types, and sums all lights at one point (or 16).

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
/// kernels pass `any_mistake` as a constant: even a branch that is never taken would cost them registers.
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

/// Like the overload above, with light from other surfaces (Arrivals::bounced), which replaces global ambient
/// light if job.bounced.
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
/// Like the overload above, if nothing blocks a light and no light arrives from other surfaces.
template <Number F> Vec3<F> shade_point(const LightJob& job, const PointAt<F>& at) {
    return shade_point(
        job, at, Vec3<F>{}, [](std::size_t) { return F(1); },
        [](std::size_t, const LightTerms<F>&, const Vec3<F>&) {});
}

}  // namespace glint::inline GLINT_ISA
