#pragma once
// Finds the polygons that meet at each edge, however many. Built from the polygon list on demand (for
// counting, creases, silhouettes), never for plain drawing.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

/// Polygon `face` runs along an edge from `corner` to next_corner(mesh, face, corner).
struct EdgeUse {
    std::uint32_t face, corner;
    bool operator==(const EdgeUse&) const = default;
};

struct Topology {
    std::vector<std::array<std::uint32_t, 2>>
        edges;                             // #E, indices of places, the smaller first; each pair once
    std::vector<std::uint32_t> first_use;  // #E + 1: edge e has the uses first_use[e] .. [e + 1)
    std::vector<EdgeUse> uses;             // every side of every polygon that joins two vertices

    [[nodiscard]] std::span<const EdgeUse> uses_of(std::size_t e) const {
        return std::span(uses).subspan(first_use[e], first_use[e + 1] - first_use[e]);
    }
};

/// Finds the edges between places (Mesh::place_of()), in the order of their first corners. Degenerate
/// polygons are included; a side from a place to itself is not an edge. Time: about linear, at most n log n.
[[nodiscard]] Topology make_topology(const Mesh& mesh);

/// The corner after `corner` around polygon `face`; the first corner after the last one.
[[nodiscard]] inline std::uint32_t next_corner(const Mesh& mesh, std::uint32_t face, std::uint32_t corner) {
    return corner + 1 < mesh.first_corner[face + 1] ? corner + 1 : mesh.first_corner[face];
}

enum class EdgeKind {
    Boundary,      // belongs to one polygon, once
    Manifold,      // two sides that run in opposite directions
    Inconsistent,  // two sides that run in the same direction: one polygon has the opposite winding
    NonManifold    // three or more sides
};
[[nodiscard]] EdgeKind edge_kind(const Mesh& mesh, const Topology& topology, std::size_t edge);

}  // namespace glint
