#pragma once
// Phong lighting: a highlight around the mirror direction, (r.v)^shininess.
// Lecture: "Phong Lighting Model"; B. T. Phong 1975.

#include "renderer/lighting/lambert.h"
#include "renderer/lighting/power.h"

namespace glint::inline GLINT_ISA {

template <Number F> Response<F> phong(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const F highlight = power(positive(dot(d.r, at.v)), m.shininess);
    return {lambert_cosine(d), {highlight, highlight, highlight}};
}

}  // namespace glint::inline GLINT_ISA
