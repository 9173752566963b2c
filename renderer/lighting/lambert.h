#pragma once
// Lambert: the reflected intensity follows the cosine of the angle of incidence and does not depend on the
// viewer. Lecture: "Lambert's Cosine Law", "Computing Diffuse Reflection".

#include "renderer/lighting/surface_point.h"

namespace glint::inline GLINT_ISA {

/// <n.l>: 0 for angles of 90 degrees or more. may_add() (illuminate.h) and certainly_behind()
/// (renderer/shade/group_bounds.h) skip such lights earlier.
template <Number F> F lambert_cosine(const Directions<F>& d) { return max0(d.n_dot_l); }

template <Number F> Response<F> lambert(const Directions<F>& d) { return {lambert_cosine(d), {}}; }

}  // namespace glint::inline GLINT_ISA
