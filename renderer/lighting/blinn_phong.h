#pragma once
// Blinn-Phong: the highlight from the halfway vector, (n.h)^shininess, as in OpenGL's fixed function.
// highlight() is in surface_point.h. Lecture: "Blinn-Phong Model"; J. Blinn 1977.

#include "renderer/lighting/lambert.h"

namespace glint::inline GLINT_ISA {

template <Number F> Response<F> blinn_phong(const Directions<F>& d, const MaterialAt<F>& m) {
    const F s = highlight(d.n_dot_unnormalized_h, d.unnormalized_h_squared, m);
    return {lambert_cosine(d), {s, s, s}};
}

}  // namespace glint::inline GLINT_ISA
