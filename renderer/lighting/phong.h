#pragma once
// Phong lighting: a highlight around the mirror direction, (r.v)^shininess.
// Lecture: "Phong Lighting Model"; B. T. Phong 1975.

#include "renderer/lighting/lambert.h"
#include "renderer/lighting/power.h"

namespace glint::inline GLINT_ISA {

template <Number F> F phong_cosine(const Directions<F>& d, const PointAt<F>& at) { return dot(d.r, at.v); }

template <Number F> Response<F> phong(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const F highlight = power(positive(phong_cosine(d, at)), m.shininess);
    return {lambert_cosine(d), {highlight, highlight, highlight}};
}

}  // namespace glint::inline GLINT_ISA
