#pragma once
// Selects the edges of a mesh that are drawn as strokes. Lecture: "Non-photorealistic shading: silhouettes
// and creases".
//
// Silhouette: (e.n0)(e.n1) <= 0, with e from the edge to the eye, and n0 and n1 the normals of its two
// facets: one facet is front-facing and the other is not. Crease: n0.n1 <= cos(crease_deg). An edge of
// exactly that angle is a crease here, although averaged normals (models/mesh/normals.h) still join across
// it.

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "models/mesh/topology.h"
#include "models/scene/shading.h"

namespace glint {

/// The edges and facet normals of a mesh, computed once.
struct MeshEdges {
    MeshPtr mesh;
    Topology topology;
    std::vector<glm::dvec3> facet_normals;  // #F, object coordinates, unit; (0, 0, 0) without an area
};
[[nodiscard]] MeshEdges mesh_edges(MeshPtr mesh);

/// The view for which edges are selected.
struct EdgeView {
    // Object coordinates: w = 1: position of the eye, w = 0: direction towards it.
    glm::dvec4 eye{0, 0, 0, 1};
    // Inverse transpose of the transform to the frame in which creases are measured.
    glm::dmat3 normal_matrix{1.0};
};

struct EdgeChoice {
    bool silhouettes = false, creases = false;
    float crease_deg = 40;  // 0 to 180
    Cull cull = Cull::None;
    bool operator==(const EdgeChoice&) const = default;
};

/// The orientation of the surface at an edge.
enum class EdgeFacing {
    Towards,  // all adjacent facets are front-facing
    Away,     // all are back-facing
    Rim       // both, or a single facet: at most one side of the edge shows the surface
};

struct StrokeEdge {
    std::uint32_t edge = 0;  // index of Topology::edges
    EdgeFacing facing = EdgeFacing::Rim;
};

/// Returns the edges to draw, in ascending order. Silhouettes include all boundary edges. An edge of three or
/// more facets is drawn if any two of them qualify (for creases, of the first 256). A facet seen exactly
/// edge-on qualifies with every other. A polygon without area does not count as a facet, but an edge that it
/// shares with a facet is not a boundary. Omits edges whose facets are all culled. Supports all non-singular
/// transforms, including reflections.
[[nodiscard]] std::vector<StrokeEdge> stroke_edges(const MeshEdges& edges, const EdgeView& view,
                                                   const EdgeChoice& choice);

}  // namespace glint
