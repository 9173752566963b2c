#include "models/mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace glint {
namespace {

PolygonPlane plane_of(const glm::dvec3& twice_area, double longest_squared) {
    const double length = std::sqrt(glm::dot(twice_area, twice_area));
    if (!(length > 1e-12 * longest_squared)) return {};
    return {twice_area / length, length / 2};
}

}  // namespace

PolygonPlane triangle_plane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a), ac = glm::dvec3(c) - glm::dvec3(a), bc = ac - ab;
    return plane_of(glm::cross(ab, ac), std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)}));
}

PolygonPlane polygon_plane(const Mesh& mesh, std::size_t face) {
    const auto corners = mesh.corners_of(face);
    const auto& p = mesh.positions;
    if (corners.size() < 3) return {};
    if (corners.size() == 3) return triangle_plane(p[corners[0]], p[corners[1]], p[corners[2]]);
    // Newell's sum equals the sum of the fan's cross products. Taken about the first corner, so that a
    // polygon far from the origin loses nothing.
    const glm::dvec3 origin(p[corners[0]]);
    glm::dvec3 twice_area(0), before = glm::dvec3(p[corners[1]]) - origin;
    double longest_squared = glm::dot(before, before);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const glm::dvec3 here = glm::dvec3(p[corners[i]]) - origin, edge = here - before;
        twice_area += glm::cross(before, here);
        longest_squared = std::max(longest_squared, glm::dot(edge, edge));
        before = here;
    }
    return plane_of(twice_area, std::max(longest_squared, glm::dot(before, before)));
}

void distinct_corners(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& corners) {
    corners.clear();
    const auto place = [&mesh](std::uint32_t corner) { return mesh.positions[mesh.corner_position[corner]]; };
    for (std::uint32_t c = mesh.first_corner[face]; c < mesh.first_corner[face + 1]; ++c)
        if (corners.empty() || place(corners.back()) != place(c)) corners.push_back(c);
    while (corners.size() > 1 && place(corners.back()) == place(corners.front())) corners.pop_back();
}

}  // namespace glint
