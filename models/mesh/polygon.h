#pragma once
// One polygon of a mesh: its plane and size, in double, shared by cutting, normals and counting
// (docs/scene_file.md, "The lighting equation").

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

struct PolygonPlane {
    glm::dvec3 normal{0};  // Newell's unit normal, object coordinates; (0, 0, 0) if the polygon has no area
    double area = 0;       // projected along the normal, in square scene units
};

/// The plane of the triangle a, b, c. The area is 0 if |(b - a) x (c - a)| <= 1e-12 (longest edge)^2.
[[nodiscard]] PolygonPlane triangle_plane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The plane of polygon `face` by Newell's method, with the same threshold. A polygon with fewer than three
/// distinct corners has no area.
[[nodiscard]] PolygonPlane polygon_plane(const Mesh& mesh, std::size_t face);

/// Sets `corners` to the corners of polygon `face` without those that repeat the position of the corner
/// before them (or, at the end, that of the first corner). The first corner of a run of equal positions
/// stays.
void distinct_corners(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& corners);

}  // namespace glint
