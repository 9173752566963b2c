#pragma once
// Blinn-Phong: the highlight from the halfway vector, (n.h)^shininess; what OpenGL's fixed function does.
// Lecture: "Blinn-Phong Model"; J. Blinn 1977.

#include "renderer/lighting/lambert.h"

namespace glint::inline GLINT_ISA {

template <Number F> F blinn_cosine(const Directions<F>& d, const PointAt<F>& at) { return dot(at.n, d.h); }

template <Number F>
Response<F> blinn_phong(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const F s = highlight(blinn_cosine(d, at), m);
    return {lambert_cosine(d), {s, s, s}};
}

}  // namespace glint::inline GLINT_ISA
