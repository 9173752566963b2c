#pragma once
// Retro-reflection: light returns towards its source, (l.v)^shininess.
// Lecture: "Types of Reflection".

#include "renderer/lighting/lambert.h"

namespace glint::inline GLINT_ISA {

template <Number F> Response<F> retro(const Directions<F>& d, const MaterialAt<F>& m) {
    const F s = highlight(d.l_dot_v, m);
    return {lambert_cosine(d), {s, s, s}};
}

}  // namespace glint::inline GLINT_ISA
