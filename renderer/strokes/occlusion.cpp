#include "renderer/strokes/occlusion.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "renderer/geometry/to_screen.h"

namespace glint {

Occlusion::Occlusion(const Geometry& g)
    : g_(g),
      orthographic_(is_orthographic(g.camera.projection)),
      near_(near_of(g.camera.projection)),
      far_(far_of(g.camera.projection)),
      half_pixel_(glm::abs(1 / (g.clip_from_view[1][1] * g.size.height))) {}

bool Occlusion::hides(std::uint32_t triangle, glm::dvec2 pixel, double inv_w) const {
    // Nearness over a plane is k . (x, y, 1) on the screen, so at each corner, in clip coordinates,
    // k . (x, y, w) = inv_w w: 1 in perspective, wherever the corner lies. Solved by Cramer's rule.
    const std::uint32_t o = g_.object_of(triangle);
    const auto corner = g_.position_indices(o, g_.triangle(o, triangle));
    glm::dmat3 corners;
    glm::dvec3 right(1);
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t c = corner[static_cast<std::size_t>(i)];
        const TransformedVertex& v = g_.objects[o].vertices[c];
        corners[i] = {v.clip_x, v.clip_y, v.clip_w};
        if (orthographic_) right[i] = (v.z + far_) / (far_ - near_);
    }
    const glm::dvec3 across = glm::cross(corners[1], corners[2]);
    const double determinant = glm::dot(corners[0], across);
    if (determinant == 0) return false;
    const glm::dvec3 k = (right[0] * across + right[1] * glm::cross(corners[2], corners[0]) +
                          right[2] * glm::cross(corners[0], corners[1])) /
                         determinant;
    const glm::dvec3 at(to_ndc(viewport_of(g_.camera, g_.size), pixel), 1);
    const double tolerance = orthographic_ ? half_pixel_ / (far_ - near_) : half_pixel_ * inv_w;
    return glm::dot(k, at) > inv_w + tolerance;
}

}  // namespace glint
