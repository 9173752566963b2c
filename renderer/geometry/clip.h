#pragma once
// Clipping in homogeneous coordinates, before anything is divided (OpenGL 2.1, section 2.12).

#include <glm/vec4.hpp>
#include <vector>

#include "renderer/geometry/outside_bits.h"

namespace glint {

/// The part of a convex polygon (clip coordinates) inside near, far and guard band, in the same order around;
/// empty when nothing is left. A cut edge gives the same new corner whichever of its two faces is clipped, so
/// that no crack opens. `spare` is memory to work in. Source: I. Sutherland, G. Hodgman 1974.
void clip_polygon(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& spare);

}  // namespace glint
