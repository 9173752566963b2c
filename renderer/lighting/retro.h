#pragma once
// Retro-reflection: light goes back towards where it came from, (l.v)^shininess.
// Lecture: "Types of Reflection".

#include "renderer/lighting/lambert.h"

namespace glint::inline GLINT_ISA {

template <Number F> F retro_cosine(const Directions<F>& d, const PointAt<F>& at) { return dot(d.l, at.v); }

template <Number F> Response<F> retro(const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const F s = highlight(retro_cosine(d, at), m);
    return {lambert_cosine(d), {s, s, s}};
}

}  // namespace glint::inline GLINT_ISA
