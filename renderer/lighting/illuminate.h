#pragma once
// The lighting equation, once. Camera coordinates, linear RGB. Lecture: "Phong Lighting Model".
//
//   I = k_e + k_a I_a + sum over lights of falloff spot (k_a A + k_d D <n.l> + k_s S spec)
//
// Every step is a named member, so the picture adds the same values that the inspector prints.

#include "models/scene/shading.h"
#include "renderer/lighting/equation_mistakes.h"
#include "renderer/lighting/light_source.h"
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
/// points elsewhere. Checked first, because this is true in half of most pictures.
template <Number F>
bool may_add(const Equation& equation, const LightAt<F>& light, const LightVector<F>& light_vector) {
    if (equation.mistakes) return true;
    if (light.has_cone && !may_be_inside(light, light_vector.xyz)) return false;
    return (equation.terms.ambient && light.has_ambient) || any(light_vector.n_dot > F(0));
}

/// Each component within 0 to 1; NaN gives 0.
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

}  // namespace glint::inline GLINT_ISA
