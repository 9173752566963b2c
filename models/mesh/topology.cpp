#include "models/mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace glint {
namespace {

/// A side of a polygon: the two vertices, the smaller first, and its polygon.
struct Side {
    std::array<std::uint32_t, 2> edge;
    EdgeUse use;
};

/// All sides of polygons, sorted by their edge and their corner.
std::vector<Side> sorted_sides(const Mesh& mesh) {
    std::vector<Side> sides, sorted;
    sides.reserve(mesh.corner_position.size());
    std::vector<std::uint32_t> end(mesh.positions.size() + 1, 0);  // of the sides with each smaller vertex
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            const std::uint32_t a = mesh.place_of(c), b = mesh.place_of(next_corner(mesh, f, c));
            if (a == b) continue;
            sides.push_back({{std::min(a, b), std::max(a, b)}, {f, c}});
            ++end[std::min(a, b) + 1];
        }
    std::partial_sum(end.begin(), end.end(), end.begin());
    sorted.resize(sides.size());
    for (const Side& side : sides) sorted[end[side.edge[0]]++] = side;
    for (std::size_t v = 0, from = 0; v < mesh.positions.size(); from = end[v++])
        std::sort(sorted.begin() + std::ptrdiff_t(from), sorted.begin() + std::ptrdiff_t(end[v]),
                  [](const Side& x, const Side& y) {
                      return x.edge[1] != y.edge[1] ? x.edge[1] < y.edge[1] : x.use.corner < y.use.corner;
                  });
    return sorted;
}

}  // namespace

Topology make_topology(const Mesh& mesh) {
    const std::vector<Side> sides = sorted_sides(mesh);
    const auto begins_edge = [&sides](std::size_t s) { return s == 0 || sides[s].edge != sides[s - 1].edge; };
    std::vector<std::uint32_t> first_side(mesh.corner_position.size(), no_index);  // of the edge from there
    for (std::size_t s = 0; s < sides.size(); ++s)
        if (begins_edge(s)) first_side[sides[s].use.corner] = static_cast<std::uint32_t>(s);
    Topology t;
    t.uses.reserve(sides.size());
    for (std::size_t s : first_side) {
        if (s == no_index) continue;
        t.edges.push_back(sides[s].edge);
        t.first_use.push_back(static_cast<std::uint32_t>(t.uses.size()));
        do t.uses.push_back(sides[s++].use);
        while (s < sides.size() && !begins_edge(s));
    }
    t.first_use.push_back(static_cast<std::uint32_t>(t.uses.size()));
    return t;
}

EdgeKind edge_kind(const Mesh& mesh, const Topology& topology, std::size_t edge) {
    const auto uses = topology.uses_of(edge);
    if (uses.size() == 1) return EdgeKind::Boundary;
    if (uses.size() > 2) return EdgeKind::NonManifold;
    const bool same = mesh.place_of(uses[0].corner) == mesh.place_of(uses[1].corner);
    return same ? EdgeKind::Inconsistent : EdgeKind::Manifold;
}

}  // namespace glint
