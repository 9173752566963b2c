#pragma once
// Shared parts of the generators of primitives. Inside models/ only.

#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/progress.h"

namespace glint {

/// A polygon mesh under construction, in double until it is centred. Adding to it reports the load's progress
/// regularly and may throw LoadCancelled.
struct PrimitiveBuilder {
    std::vector<glm::dvec3> positions, normals;
    std::vector<std::uint32_t> first_corner{0}, corner_position;
    std::vector<std::uint32_t> corner_normal;  // empty: normals are by position
    std::vector<glm::vec3> colors;

    /// Adds a position with its normal; returns its index.
    std::uint32_t vertex(const glm::dvec3& position, const glm::dvec3& normal) {
        if (positions.size() % between_reports == 0) report_or_leave(LoadStage::Building, face_count());
        positions.push_back(position);
        normals.push_back(normal);
        return static_cast<std::uint32_t>(positions.size() - 1);
    }
    /// A polygon whose corners use the normals of their positions.
    void face(std::initializer_list<std::uint32_t> corners) {
        corner_position.insert(corner_position.end(), corners);
        close_face();
    }
    /// Adds a corner of the polygon that close_face() ends. Used if normals are not by position.
    void corner(std::uint32_t position, std::uint32_t normal) {
        corner_position.push_back(position);
        corner_normal.push_back(normal);
    }
    void close_face() {
        if (first_corner.size() % between_reports == 0) report_or_leave(LoadStage::Building, face_count());
        first_corner.push_back(static_cast<std::uint32_t>(corner_position.size()));
    }
    [[nodiscard]] std::size_t face_count() const { return first_corner.size() - 1; }

    static constexpr std::size_t between_reports = 1 << 14;  // vertices, faces
};

/// Adds a grid of quads that is closed in both directions, `columns` to the right by `rows` up as seen from
/// outside: vertex (i, j) has the index i * rows + j. Precondition: the vertices exist.
void add_closed_grid(PrimitiveBuilder& to, std::uint32_t columns, std::uint32_t rows);

}  // namespace glint
