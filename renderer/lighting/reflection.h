#pragma once
// Dispatches to the reflection models. To add a model, see docs/changing.md.

#include "models/scene/reflection.h"
#include "renderer/lighting/light_job.h"
#include "renderer/lighting/surface_point.h"

namespace glint::inline GLINT_ISA {

// Lambert: the reflected intensity follows the cosine of the angle of incidence and does not depend on the
// viewer. Lecture: "Lambert's Cosine Law", "Computing Diffuse Reflection".

/// <n.l>: 0 for angles of 90 degrees or more. may_add() (illuminate.h) and certainly_behind()
/// (renderer/shade/group_bounds.h) skip such lights earlier.
template <Number F> F lambert_cosine(const Directions<F>& d) { return max0(d.n_dot_l); }

template <Number F> Response<F> lambert(const Directions<F>& d) { return {lambert_cosine(d), {}}; }

// Oren-Nayar: a model for rough surfaces (chalk, the moon), flatter towards the edge than Lambert. M. Oren,
// S. Nayar 1994, the qualitative model: A + B max(cos dphi, 0) sin alpha tan beta. alpha and beta are the
// larger and the smaller of the angles of l and v with n, and dphi is the azimuth between l and v around n.

/// The standard deviation of the facet slope, in degrees, for a roughness of 1.
inline constexpr double max_sigma_deg = 90;

/// The factor of the cosine: A + B max(cos dphi, 0) sin alpha tan beta. A `roughness` of 0 to 1 maps to a
/// deviation of 0 to max_sigma_deg.
template <Number F> F roughness_factor(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const F sigma = m.roughness * F(static_cast<float>(max_sigma_deg * 3.14159265358979323846 / 180));
    const F variance = sigma * sigma;
    const F a = F(1) - F(0.5f) * variance / (variance + F(0.33f));
    const F b = F(0.45f) * variance / (variance + F(0.09f));
    // sin theta_l sin theta_v cos dphi = l.v - (n.l)(n.v). sin alpha tan beta is the product of the sines
    // divided by cos beta, the larger cosine.
    const F azimuth = d.l_dot_v - d.n_dot_l * at.n_dot_v;
    const F larger_cosine = max(d.n_dot_l, at.n_dot_v);
    const F rough = max0(azimuth) * inverse_or_zero(larger_cosine);
    return a + b * rough;
}

template <Number F>
Response<F> oren_nayar(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    return {lambert_cosine(d) * roughness_factor(d, m, at), {}};
}

// Cool-to-warm shading: the side facing the light is warm, the side facing away is cool, and nothing is
// black, so that strokes and highlights are clearly visible. Lecture: "Non-photorealistic shading: cool to
// warm"; A. Gooch, B. Gooch, P. Shirley, E. Cohen 1998. The weights follow the lecture; the paper's printed
// equation swaps them.

/// The intermediate values of the tone at one point; linear RGB, not clamped.
template <Number F> struct CoolToWarmTerms {
    F n_dot_l{};         // not clamped; 0 without a light, at the light's position and if n is zero
    F k_w{};             // fraction of the warm tone, 0 to 1: (1 + n.l) / 2
    Vec3<F> cool, warm;  // cool + alpha k_d, warm + beta k_d
    Vec3<F> color;       // k_w warm + (1 - k_w) cool
};

template <Number F>
CoolToWarmTerms<F> cool_to_warm(const CoolToWarm& tone, Vec3<F> k_d, const PointAt<F>& at) {
    CoolToWarmTerms<F> t;
    LightAt<F> light;
    light.xyz = broadcast<F>(tone.light);
    light.w = F(tone.light_w);
    t.n_dot_l = dot(at.n, unit(vector_to_light(light, at.p)));
    t.k_w = F(0.5f) * (F(1) + t.n_dot_l);
    t.cool = broadcast<F>(tone.cool) + F(tone.alpha) * k_d;
    t.warm = broadcast<F>(tone.warm) + F(tone.beta) * k_d;
    t.color = t.k_w * t.warm + (F(1) - t.k_w) * t.cool;
    return t;
}

// Phong lighting: a highlight around the mirror direction, (r.v)^shininess.
// Lecture: "Phong Lighting Model"; B. T. Phong 1975.

template <Number F> Response<F> phong(const Directions<F>& d, const MaterialAt<F>& m) {
    const F s = highlight(d.r_dot_v, m);
    return {lambert_cosine(d), {s, s, s}};
}

// Blinn-Phong: the highlight from the halfway vector, (n.h)^shininess, as in OpenGL's fixed function.
// highlight() is in surface_point.h. Lecture: "Blinn-Phong Model"; J. Blinn 1977.

template <Number F> Response<F> blinn_phong(const Directions<F>& d, const MaterialAt<F>& m) {
    const F s = highlight(d.n_dot_unnormalized_h, d.unnormalized_h_squared, m);
    return {lambert_cosine(d), {s, s, s}};
}

// Retro-reflection: light returns towards its source, (l.v)^shininess.
// Lecture: "Types of Reflection".

template <Number F> Response<F> retro(const Directions<F>& d, const MaterialAt<F>& m) {
    const F s = highlight(d.l_dot_v, m);
    return {lambert_cosine(d), {s, s, s}};
}

// Cook-Torrance: a microfacet highlight, D G F / (4 n.l n.v). R. Cook, K. Torrance 1982, with modern terms: D
// and G of Trowbridge-Reitz (GGX), G height-correlated (E. Heitz, JCGT 2014), F by C. Schlick 1994.
// a = roughness^2 (B. Burley 2012), not below 0.001. As a factor of this equation: f pi n.l = pi D G F / (4
// n.v), because its Lambert term has no 1/pi.

/// The width of the facet distribution for a roughness of 0 to 1: roughness^2, at least min_alpha.
inline constexpr float min_alpha = 0.001f;
template <Number F> F ggx_alpha(F roughness) { return max(roughness * roughness, F(min_alpha)); }

/// Density of facets with normal h per unit solid angle; weighted by the cosine n.h, it integrates to 1. The
/// denominator uses the sine |n x h|, because rounding 1 - (n.h)^2 would lose the narrow peak of a smooth
/// surface.
template <Number F> F d_ggx(Vec3<F> n, Vec3<F> h, F a) {
    const F cosine = max0(dot(n, h));
    const Vec3<F> sine = cross(n, h);
    const F t = cosine * cosine * (a * a) + dot(sine, sine);
    return a * a / (F(3.14159265f) * (t * t));
}

/// Smith's Lambda for a direction whose cosine with n is c > 0.
template <Number F> F lambda_ggx(F c, F a) {
    const F tan2 = F(1) / (c * c) - F(1);
    return F(0.5f) * (square_root(F(1) + a * a * max0(tan2)) - F(1));
}

/// Schlick's Fresnel factor for the cosine c between h and v.
template <Number F> F f_schlick(F f0, F c) {
    const F grazing = F(1) - c, squared = grazing * grazing;
    return f0 + (F(1) - f0) * (squared * squared * grazing);
}

/// The factors of the highlight: S = pi D G F / (4 n.v) if light and eye are both in front of the surface.
template <Number F> struct FacetTerms {
    F d{}, g{}, cos_v{};
    Vec3<F> f;
};
template <Number F>
FacetTerms<F> facet_terms(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const F a = ggx_alpha(m.roughness);
    const F n_dot_v = dot(at.n, at.v), v_dot_h = max0(dot(at.v, d.h));
    const auto lit = mask_and(d.n_dot_l > F(0), n_dot_v > F(0));
    const F cos_l = select(lit, d.n_dot_l, F(1)), cos_v = select(lit, n_dot_v, F(1));
    const F g = F(1) / (F(1) + lambda_ggx(cos_l, a) + lambda_ggx(cos_v, a));
    return {d_ggx(at.n, d.h, a),
            g,
            cos_v,
            {f_schlick(m.f0.x, v_dot_h), f_schlick(m.f0.y, v_dot_h), f_schlick(m.f0.z, v_dot_h)}};
}

template <Number F>
Response<F> cook_torrance(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const FacetTerms<F> t = facet_terms(d, m, at);
    const auto lit = mask_and(d.n_dot_l > F(0), dot(at.n, at.v) > F(0));
    const F shared = select(lit, F(3.14159265f) * t.d * t.g / (F(4) * t.cos_v), F(0));
    return {lambert_cosine(d), shared * t.f};
}

template <Number F>
Response<F> respond(Reflection model, const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    switch (model) {
    case Reflection::None:
        return {};
    case Reflection::Lambert:
        return lambert(d);
    case Reflection::Phong:
        return phong(d, m);
    case Reflection::BlinnPhong:
        return blinn_phong(d, m);
    case Reflection::Retro:
        return retro(d, m);
    case Reflection::OrenNayar:
        return oren_nayar(d, m, at);
    case Reflection::CookTorrance:
        return cook_torrance(d, m, at);
    }
    return {};  // unreachable
}

}  // namespace glint::inline GLINT_ISA
