#pragma once
// Cool-to-warm shading: the side facing the light is warm, the side facing away is cool, and nothing is
// black, so that strokes and highlights are clearly visible. Lecture: "Non-photorealistic shading: cool to
// warm"; A. Gooch, B. Gooch, P. Shirley, E. Cohen 1998. The weights follow the lecture; the paper's printed
// equation swaps them.

#include "renderer/lighting/light_job.h"
#include "renderer/lighting/light_source.h"
#include "renderer/lighting/surface_point.h"

namespace glint::inline GLINT_ISA {

/// The intermediate values of the tone at one point; linear RGB, not clamped.
template <Number F> struct CoolToWarmTerms {
    F n_dot_l{};         // not clamped; 0 without a light, at the light's position and if n is zero
    F k_w{};             // share of the warm tone, 0 to 1: (1 + n.l) / 2
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

}  // namespace glint::inline GLINT_ISA
