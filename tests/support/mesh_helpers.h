#pragma once
// Small meshes for tests.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint::test {

inline Mesh make_mesh(std::vector<glm::vec3> positions,
                      const std::vector<std::vector<std::uint32_t>>& faces) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    mesh.first_corner.push_back(0);
    for (const auto& face : faces) {
        mesh.corner_position.insert(mesh.corner_position.end(), face.begin(), face.end());
        mesh.first_corner.push_back(static_cast<std::uint32_t>(mesh.corner_position.size()));
    }
    finish_mesh(mesh);
    return mesh;
}

/// One polygon through these points, in order.
inline Mesh make_polygon(std::vector<glm::vec3> points) {
    std::vector<std::uint32_t> face;
    for (std::uint32_t i = 0; i < points.size(); ++i) face.push_back(i);
    return make_mesh(std::move(points), {face});
}

inline glm::dvec3 corner_place(const Mesh& mesh, std::uint32_t corner) {
    return glm::dvec3(mesh.positions[mesh.corner_position[corner]]);
}

}  // namespace glint::test
