#pragma once
// Clipping in homogeneous coordinates, before anything is divided (OpenGL 2.1, section 2.12).

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "renderer/geometry/outside_bits.h"

namespace glint {

/// The part of the view volume with |x| <= side_x w and |y| <= side_y w, as planes in clip coordinates:
/// inside where dot(plane, corner) >= 0. The near plane comes first.
inline constexpr glm::dvec4 near_plane{0, 0, 1, 1};
[[nodiscard]] constexpr std::array<glm::dvec4, 6> view_planes(double side_x, double side_y) {
    return {near_plane,
            glm::dvec4{0, 0, -1, 1},
            glm::dvec4{1, 0, 0, side_x},
            glm::dvec4{-1, 0, 0, side_x},
            glm::dvec4{0, 1, 0, side_y},
            glm::dvec4{0, -1, 0, side_y}};
}

/// The part of a convex polygon (clip coordinates) inside near, far and guard band, in the same order around;
/// empty when nothing is left. A cut edge gives the same new corner whichever of its two faces is clipped, so
/// that no crack opens. `spare` is memory to work in. Source: I. Sutherland, G. Hodgman 1974.
void clip_polygon(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& spare);

}  // namespace glint
