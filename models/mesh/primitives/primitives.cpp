#include "models/mesh/primitives/primitives.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "models/mesh/primitives/primitive_builder.h"

namespace glint {
namespace {

/// The centre of the bounds; exactly 0 if it differs from 0 only by rounding.
glm::dvec3 middle_of_bounds(const std::vector<glm::dvec3>& positions) {
    glm::dvec3 low = positions.front(), high = low;
    for (const glm::dvec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    glm::dvec3 middle = (low + high) / 2.0;
    for (int i = 0; i < 3; ++i)
        if (std::abs(middle[i]) < 1e-12) middle[i] = 0;
    return middle;
}

}  // namespace

void add_closed_grid(PrimitiveBuilder& to, std::uint32_t columns, std::uint32_t rows) {
    const auto at = [=](std::uint32_t i, std::uint32_t j) { return i % columns * rows + j % rows; };
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j)
            to.face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
}

Mesh make_primitive(Primitive primitive, int detail) {
    const auto start = std::chrono::steady_clock::now();
    PrimitiveBuilder built = info_of(primitive).make(detail);
    const glm::dvec3 middle = middle_of_bounds(built.positions);
    Mesh mesh;
    mesh.positions.reserve(built.positions.size());
    for (const glm::dvec3& p : built.positions) mesh.positions.emplace_back(p - middle);
    mesh.normals.reserve(built.normals.size());
    for (const glm::dvec3& n : built.normals) mesh.normals.emplace_back(glm::normalize(n));
    mesh.first_corner = std::move(built.first_corner);
    mesh.corner_position = std::move(built.corner_position);
    mesh.corner_normal = std::move(built.corner_normal);
    mesh.colors = std::move(built.colors);
    mesh.given_normals = GivenNormals::Analytic;
    finish_mesh(mesh);
    mesh.load_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return mesh;
}

}  // namespace glint
