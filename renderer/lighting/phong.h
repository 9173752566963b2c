#pragma once
// Phong lighting: a highlight around the mirror direction, (r.v)^shininess.
// Lecture: "Phong Lighting Model"; B. T. Phong 1975.

#include "renderer/lighting/lambert.h"

namespace glint::inline GLINT_ISA {

template <Number F> Response<F> phong(const Directions<F>& d, const MaterialAt<F>& m) {
    const F s = highlight(d.r_dot_v, m);
    return {lambert_cosine(d), {s, s, s}};
}

}  // namespace glint::inline GLINT_ISA
