#pragma once
// Clipping in homogeneous coordinates, before anything is divided (OpenGL 2.1, section 2.12).

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory_resource>
#include <span>
#include <vector>

#include "renderer/geometry/geometry.h"
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

// A face in front of the near plane, on the screen: what interpolation on the screen works with.

/// A corner of the cut face. It lies between two of the face's own corners (or on `a`, with t = 0), at the
/// perspective-correct share t from a to b.
struct ClippedCorner {
    glm::dvec2 pixel{0};  // on the screen, in pixels, y down
    std::uint32_t a = 0, b = 0;
    double t = 0;
};

/// Memory for one face of usual size on the stack, so that a pixel costs no allocation.
struct ClipMemory {
    std::array<std::byte, 4096> bytes;
    std::pmr::monotonic_buffer_resource pool{bytes.data(), bytes.size()};
};

/// The part of a face in front of the near plane. `corners`: indices into Mesh::corner_position, in order.
[[nodiscard]] std::pmr::vector<ClippedCorner> clip_at_near(const Geometry& geometry, std::uint32_t object,
                                                           std::span<const std::uint32_t> corners,
                                                           ClipMemory& memory);

}  // namespace glint
