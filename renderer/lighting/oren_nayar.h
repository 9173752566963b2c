#pragma once
// Oren-Nayar: a model for rough surfaces (chalk, the moon), flatter towards the edge than Lambert. M. Oren,
// S. Nayar 1994, the qualitative model: A + B max(cos dphi, 0) sin alpha tan beta. alpha and beta are the
// larger and the smaller of the angles of l and v with n, and dphi is the azimuth between l and v around n.

#include "renderer/lighting/lambert.h"

namespace glint::inline GLINT_ISA {

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

}  // namespace glint::inline GLINT_ISA
