#pragma once
// Cook-Torrance: a microfacet highlight, D G F / (4 n.l n.v). R. Cook, K. Torrance 1982, with modern terms: D
// and G of Trowbridge-Reitz (GGX), G height-correlated (E. Heitz, JCGT 2014), F by C. Schlick 1994.
// a = roughness^2 (B. Burley 2012), not below 0.001. As a factor of this equation: f pi n.l = pi D G F / (4
// n.v), because its Lambert term has no 1/pi.

#include "renderer/lighting/lambert.h"

namespace glint::inline GLINT_ISA {

/// The width of the facet distribution for a roughness of 0 to 1: roughness^2, at least min_alpha.
inline constexpr float min_alpha = 0.001f;
template <Number F> F ggx_alpha(F roughness) { return max(roughness * roughness, F(min_alpha)); }

/// Density of facets with normal h per unit solid angle; its integral with the cosine n.h is 1. The
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

}  // namespace glint::inline GLINT_ISA
