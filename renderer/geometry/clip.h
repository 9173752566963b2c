#pragma once
// Clips in homogeneous coordinates, before the division by w (OpenGL 2.1, section 2.12), and transforms
// single vertices to the screen.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory_resource>
#include <span>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/geometry_kernels.h"
#include "renderer/geometry/interpolate.h"
#include "renderer/geometry/vertex_transform.h"

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

/// The part of a convex polygon (clip coordinates) between the near and far planes and inside the guard band,
/// with the same winding; empty when nothing is left. Both faces of a cut edge get the same new corner, which
/// avoids cracks. `spare` is scratch memory. Source: I. Sutherland, G. Hodgman 1974.
void clip_polygon(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& spare);

// The part of a face in front of the near plane, on the screen, for interpolation on the screen.

/// A corner of the cut face. It is between two of the face's own corners (or at `a`, with t = 0), at the
/// perspective-correct fraction t from a to b.
struct ClippedCorner {
    glm::dvec2 pixel{0};  // on the screen, in pixels, y down
    std::uint32_t a = 0, b = 0;
    double t = 0;
};

/// Stack memory for one face of typical size, so that a pixel costs no allocation.
struct ClipMemory {
    std::array<std::byte, 4096> bytes;
    std::pmr::monotonic_buffer_resource pool{bytes.data(), bytes.size()};
};

/// The part of a face in front of the near plane, for interpolation on the screen; drawn triangles are
/// clipped by clip_polygon(). `corners`: indices into Mesh::corner_position, in order.
[[nodiscard]] std::pmr::vector<ClippedCorner> clip_at_near(const Geometry& geometry, std::uint32_t object,
                                                           std::span<const std::uint32_t> corners,
                                                           ClipMemory& memory);

// The kernels' viewport transform for a single vertex. Unclipped triangles and clipped pieces use the same
// formulas, which avoids cracks between them.

[[nodiscard]] inline Matrix4 matrix_of(const glm::dmat4& m) {
    Matrix4 out;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) out.column[c][r] = m[c][r];
    return out;
}

[[nodiscard]] inline Viewport viewport_of(const Camera& camera, PictureSize size) {
    return {static_cast<double>(size.width), static_cast<double>(size.height),
            is_orthographic(camera.projection)};
}

/// The kernels' to_pixel and inv_w_of for GLM's vectors. Precondition: clip.w != 0.
[[nodiscard]] inline glm::dvec2 to_pixel(const Viewport& viewport, const glm::dvec4& clip) {
    const PixelPoint<double> at = to_pixel(viewport, Point4<double>{clip.x, clip.y, clip.z, clip.w});
    return {at.x, at.y};
}
[[nodiscard]] inline double inv_w_of(const Viewport& viewport, const glm::dvec4& clip) {
    return inv_w_of(viewport, Point4<double>{clip.x, clip.y, clip.z, clip.w});
}
/// The inverse of to_pixel: x and y from -1 (left, bottom) to 1 (right, top).
[[nodiscard]] inline glm::dvec2 to_ndc(const Viewport& viewport, glm::dvec2 pixel) {
    const ScreenPoint<double> at = to_ndc(pixel.x, pixel.y, viewport.width, viewport.height);
    return {at.x, at.y};
}

/// Repairs w of a corner that clipping left at or inside the near plane. On an edge 1e17 units long, doubles
/// lose the position of the cut, and the corner may be far beyond the plane: its w is then set to the
/// minimum, so that dividing by w yields a number.
[[nodiscard]] inline glm::dvec4 before_eye(const Projection& projection, const glm::dvec4& clip) {
    const double least_w = is_orthographic(projection) ? 0.5 : 0.5 * static_cast<double>(near_of(projection));
    return {clip.x, clip.y, clip.z, std::max(clip.w, least_w)};
}

/// Moves a corner that clipping left beyond the near plane or the guard band (see before_eye) to the nearest
/// point that fits the rasterizer's grid; leaves others unchanged.
[[nodiscard]] inline glm::dvec4 held_in_view(const Projection& projection, const glm::dvec4& clip) {
    const glm::dvec4 c = before_eye(projection, clip);
    const double side = (guard_band + 1) * c.w, depth = 1.001 * c.w;
    return {std::clamp(c.x, -side, side), std::clamp(c.y, -side, side), std::clamp(c.z, -depth, depth), c.w};
}

/// Converts a corner that held_in_view() returned to the rasterizer's grid.
[[nodiscard]] inline ScreenVertex to_screen(const Viewport& viewport, const glm::dvec4& clip) {
    const GridPoint<double> at = grid_point(viewport, Point4<double>{clip.x, clip.y, clip.z, clip.w});
    return {static_cast<std::int32_t>(nearest(at.x)), static_cast<std::int32_t>(nearest(at.y)),
            static_cast<float>(at.inv_w)};
}

}  // namespace glint
