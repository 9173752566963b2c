#pragma once
// Selects the edges of a mesh that are drawn as strokes. Lecture: "Non-photorealistic shading: silhouettes
// and creases".
//
// Silhouette: (e.n0)(e.n1) <= 0, e from the edge to the eye, n0 and n1 the normals of its two facets: one is
// seen from the front and the other is not. Crease: n0.n1 <= cos(crease_deg); an edge of exactly that angle
// is a crease here, while averaged normals (models/mesh/normals.h) still join across it.

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "models/mesh/topology.h"
#include "models/scene/shading.h"

namespace glint {

/// The edges and facet normals of a mesh, made once.
struct MeshEdges {
    MeshPtr mesh;
    Topology topology;
    std::vector<glm::dvec3> facet_normals;  // #F, object coordinates, unit; (0, 0, 0) without an area
};
[[nodiscard]] MeshEdges mesh_edges(MeshPtr mesh);

/// How the mesh is seen.
struct EdgeView {
    glm::dvec4 eye{0, 0, 0, 1};  // object coordinates: w = 1 the eye's place, w = 0 the direction towards it
    glm::dmat3 normal_matrix{1.0};  // inverse transpose to the frame in which creases are measured
};

struct EdgeChoice {
    bool silhouettes = false, creases = false;
    float crease_deg = 40;  // 0 to 180
    Cull cull = Cull::None;
    bool operator==(const EdgeChoice&) const = default;
};

/// How the surface lies around an edge.
enum class EdgeFacing {
    Towards,  // all its facets are seen from the front
    Away,     // all from behind
    Rim       // some from each, or there is but one: the surface is seen on one side of the edge at most
};

struct StrokeEdge {
    std::uint32_t edge = 0;  // of Topology::edges
    EdgeFacing facing = EdgeFacing::Rim;
};

/// Returns the edges to draw, in rising order. Silhouettes include all boundary edges. An edge of three
/// facets and more is drawn when any two of them qualify (for creases, of the first 256); a facet seen
/// exactly edge-on qualifies with every other. A polygon without an area is not a facet, but the edge that it
/// shares with one is not a boundary. Edges whose facets are all culled are left out. Any transform that is
/// not singular, mirrored ones too.
[[nodiscard]] std::vector<StrokeEdge> stroke_edges(const MeshEdges& edges, const EdgeView& view,
                                                   const EdgeChoice& choice);

}  // namespace glint
