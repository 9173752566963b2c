// Selects the edges drawn as strokes: silhouettes, between a front-facing facet and one that is not, and
// creases, between two facets at a sharp angle.
#include "renderer/strokes/stroke_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "models/mesh/polygon.h"

namespace glint {
namespace {

constexpr std::size_t chunk_size = 16384;  // edges per task

/// Tests single edges. Stores the values common to all of them.
class Selector {
  public:
    Selector(const MeshEdges& edges, const EdgeView& view, const EdgeChoice& choice)
        : edges_(edges),
          view_(view),
          choice_(choice),
          max_cosine_(std::cos(glm::radians(static_cast<double>(choice.crease_deg))) + crease_tolerance) {}

    void examine(std::size_t edge, std::vector<StrokeEdge>& found) const {
        const auto uses = edges_.topology.uses_of(edge);
        const glm::dvec3 e = to_eye(edge);
        int facets = 0, min_side = 1, max_side = -1;
        for (const EdgeUse& use : uses) {
            const glm::dvec3& n = edges_.facet_normals[use.face];
            if (n == glm::dvec3(0)) continue;
            ++facets;
            min_side = std::min(min_side, side(e, n));
            max_side = std::max(max_side, side(e, n));
        }
        if (facets == 0 || (choice_.cull == Cull::Back && max_side < 0) ||
            (choice_.cull == Cull::Front && min_side > 0))
            return;
        // One facet faces the eye and another does not, or one is seen edge-on.
        const bool differ = facets > 1 && min_side <= 0 && max_side >= 0;
        const bool is_silhouette = choice_.silhouettes && (uses.size() == 1 || differ);
        if (is_silhouette || (choice_.creases && facets > 1 && is_crease(uses)))
            found.push_back({static_cast<std::uint32_t>(edge), differ || facets == 1 ? EdgeFacing::Rim
                                                               : min_side > 0        ? EdgeFacing::Towards
                                                                                     : EdgeFacing::Away});
    }

  private:
    // In floating point, cos 90 degrees is not exactly 0, and the facets of a rotated cube are not exactly at
    // right angles.
    static constexpr double crease_tolerance = 1e-6;
    // The sine of the angle below which a facet counts as seen edge-on. Only rounding errors are this small.
    static constexpr double edge_on = 1e-12;
    // A crease compares every pair of facets. The limit prevents 10^12 steps for a file with a million facets
    // at one edge.
    static constexpr std::size_t max_compared = 256;

    [[nodiscard]] glm::dvec3 to_eye(std::size_t edge) const {
        const auto& p = edges_.mesh->positions;
        const auto [a, b] = edges_.topology.edges[edge];
        const glm::dvec3 middle = 0.5 * (glm::dvec3(p[a]) + glm::dvec3(p[b]));
        return glm::dvec3(view_.eye) - view_.eye.w * middle;
    }

    /// 1 if the facet is front-facing, -1 if back-facing, 0 if edge-on.
    static int side(const glm::dvec3& e, const glm::dvec3& n) {
        const double towards_eye = glm::dot(e, n), limit = edge_on * std::sqrt(glm::dot(e, e));
        return towards_eye > limit ? 1 : towards_eye < -limit ? -1 : 0;
    }

    [[nodiscard]] bool is_crease(std::span<const EdgeUse> uses) const {
        uses = uses.first(std::min(uses.size(), max_compared));
        for (std::size_t i = 0; i < uses.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (meet_sharply(edges_.facet_normals[uses[i].face], edges_.facet_normals[uses[j].face]))
                    return true;
        return false;
    }

    [[nodiscard]] bool meet_sharply(const glm::dvec3& n0, const glm::dvec3& n1) const {
        const glm::dvec3 m0 = view_.normal_matrix * n0, m1 = view_.normal_matrix * n1;
        const double lengths = std::sqrt(glm::dot(m0, m0) * glm::dot(m1, m1));
        return lengths > 0 && glm::dot(m0, m1) <= max_cosine_ * lengths;
    }

    const MeshEdges& edges_;
    const EdgeView& view_;
    const EdgeChoice& choice_;
    double max_cosine_;
};

}  // namespace

MeshEdges mesh_edges(MeshPtr mesh) {
    MeshEdges edges;
    edges.topology = make_topology(*mesh);
    edges.facet_normals.resize(mesh->face_count());
    tbb::parallel_for(std::size_t{0}, edges.facet_normals.size(),
                      [&](std::size_t f) { edges.facet_normals[f] = polygon_plane(*mesh, f).normal; });
    edges.mesh = std::move(mesh);
    return edges;
}

std::vector<StrokeEdge> stroke_edges(const MeshEdges& edges, const EdgeView& view, const EdgeChoice& choice) {
    const Selector selector(edges, view, choice);
    const std::size_t count = edges.topology.edges.size();
    std::vector<std::vector<StrokeEdge>> found((count + chunk_size - 1) / chunk_size);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t chunk) {
        for (std::size_t e = chunk * chunk_size; e < std::min(count, (chunk + 1) * chunk_size); ++e)
            selector.examine(e, found[chunk]);
    });
    std::vector<StrokeEdge> all;
    for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace glint
