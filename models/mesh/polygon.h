#pragma once
// The plane and size of one polygon of a mesh, in double: what cutting, normals and counting share.

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

struct PolygonPlane {
    glm::dvec3 normal{0};  // unit, Newell's, object coordinates; (0, 0, 0) when the polygon has no area
    double area = 0;       // of the projection along the normal, in square scene units
};

/// The plane of the triangle a, b, c. No area when |(b - a) x (c - a)| <= 1e-12 (longest edge)^2.
[[nodiscard]] PolygonPlane triangle_plane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The plane of polygon `face` by Newell's method; the same threshold, so fewer than three distinct corners
/// have no area.
[[nodiscard]] PolygonPlane polygon_plane(const Mesh& mesh, std::size_t face);

/// Appends the corners of polygon `face` that do not repeat the place of the corner before them (the last
/// one, of the first) to `corners`, which is cleared first. The first corner of a run stays.
void distinct_corners(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& corners);

}  // namespace glint
