#pragma once
// Blinn-Phong: the highlight from the halfway vector, (n.h)^shininess; what OpenGL's fixed function does.
// Lecture: "Blinn-Phong Model"; J. Blinn 1977.

#include "renderer/lighting/lambert.h"
#include "renderer/lighting/power.h"

namespace glint::inline GLINT_ISA {

template <Number F>
Response<F> blinn_phong(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const F highlight = power(positive(dot(at.n, d.h)), m.shininess);
    return {lambert_cosine(d), {highlight, highlight, highlight}};
}

}  // namespace glint::inline GLINT_ISA
