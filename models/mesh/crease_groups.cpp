#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "models/mesh/circle.h"
#include "models/mesh/polygon.h"
#include "models/mesh/topology.h"

namespace glint {
namespace {

/// Sets of corners that grow together; the smallest corner of a set stands for it.
class Groups {
  public:
    explicit Groups(std::size_t corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t root(std::uint32_t c) {
        while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
        return c;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a < b) std::swap(a, b);
        parent_[a] = b;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

void join_repeated_corners(const Mesh& mesh, Groups& groups) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            const std::uint32_t next = next_corner(mesh, f, c);
            if (mesh.corner_position[c] == mesh.corner_position[next]) groups.join(c, next);
        }
}

}  // namespace

CreaseGroups crease_groups(const Mesh& mesh, const Topology& topology, float crease_deg) {
    std::vector<glm::dvec3> normal(mesh.face_count());
    for (std::size_t f = 0; f < normal.size(); ++f) normal[f] = polygon_plane(mesh, f).normal;
    // 1e-6: a cube's faces meet at 90 degrees whatever the last bit of its normals says.
    const double least = cos_sin(static_cast<double>(crease_deg) * std::numbers::pi / 180).c - 1e-6;
    Groups groups(mesh.corner_position.size());
    join_repeated_corners(mesh, groups);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        if (edge_kind(mesh, topology, e) != EdgeKind::Manifold) continue;
        const EdgeUse &f = topology.uses_of(e)[0], &g = topology.uses_of(e)[1];
        if (glm::dot(normal[f.face], normal[g.face]) < least) continue;
        groups.join(f.corner, next_corner(mesh, g.face, g.corner));  // they run in opposite directions
        groups.join(g.corner, next_corner(mesh, f.face, f.corner));
    }
    CreaseGroups result;
    result.group.resize(mesh.corner_position.size());
    for (std::uint32_t c = 0; c < result.group.size(); ++c) {
        const std::uint32_t root = groups.root(c);
        result.group[c] = root == c ? static_cast<std::uint32_t>(result.count++) : result.group[root];
    }
    return result;
}

}  // namespace glint
