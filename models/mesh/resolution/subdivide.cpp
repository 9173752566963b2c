// Subdivision: C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987; E. Catmull and J. Clark,
// "Recursively generated B-spline surfaces on arbitrary topological meshes", 1978.
#include <algorithm>
#include <utility>
#include <vector>

#include "models/mesh/resolution/half_edges.h"
#include "models/mesh/resolution/resolution.h"
#include "models/progress.h"

// These headers require OpenMesh's mesh.
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

namespace glint {
namespace {

using OpenMesh::Subdivider::Uniform::CatmullClarkT;
using OpenMesh::Subdivider::Uniform::LoopT;

OpenMesh::Vec3d double_place(const glm::vec3& v) { return {double(v.x), double(v.y), double(v.z)}; }
glm::vec3 float_place(const OpenMesh::Vec3d& v) { return {float(v[0]), float(v[1]), float(v[2])}; }

/// Returns the positions of the boundary vertices after one subdivision step. In both schemes a boundary is a
/// cubic B-spline: a step moves v, with neighbours a and b on the boundary, to (a + 6 v + b) / 8. OpenMesh
/// 9.0 does this in Loop's scheme. In the Catmull-Clark scheme it uses (a + 4 v + b) / 6, the limit of
/// infinitely many steps.
template <class HalfEdges> auto boundary_places(const HalfEdges& mesh) {
    std::vector<std::pair<OpenMesh::VertexHandle, OpenMesh::Vec3d>> places;
    for (const auto v : mesh.vertices()) {
        if (!mesh.is_boundary(v)) continue;
        const auto out = mesh.halfedge_handle(v);  // at a boundary vertex it runs along the boundary
        if (!out.is_valid()) continue;
        const auto a = mesh.to_vertex_handle(out),
                   b = mesh.from_vertex_handle(mesh.prev_halfedge_handle(out));
        places.emplace_back(v, (mesh.point(a) + 6.0 * mesh.point(v) + mesh.point(b)) / 8.0);
    }
    return places;
}

/// Returns the largest valence, at least the six of a new vertex. OpenMesh 9.0 precomputes the weights of
/// Loop's scheme up to valence 49, and reads beyond its table for more.
template <class HalfEdges> std::size_t most_neighbours(const HalfEdges& mesh) {
    std::size_t most = 6;
    for (const auto v : mesh.vertices()) most = std::max<std::size_t>(most, mesh.valence(v));
    return most;
}

/// Runs one step at a time, because a load may be cancelled between steps.
template <class Subdivider, class HalfEdges> void subdivide(HalfEdges& mesh, int times) {
    Subdivider subdivider;
    if constexpr (requires { subdivider.init_weights(); }) subdivider.init_weights(most_neighbours(mesh) + 1);
    for (int step = 0; step < times; ++step) {
        report_or_leave(LoadStage::Building, mesh.n_faces());
        const auto boundary = boundary_places(mesh);
        subdivider(mesh, 1);
        for (const auto& [vertex, place] : boundary)
            mesh.set_point(vertex, place);  // a step keeps the vertices' numbers
    }
}

template <class HalfEdges> std::vector<glm::vec3> places_in(const HalfEdges& mesh) {
    std::vector<glm::vec3> places;
    places.reserve(mesh.n_vertices());
    for (const auto v : mesh.vertices()) places.push_back(float_place(mesh.point(v)));
    return places;
}

template <class HalfEdges> void copy_faces(const HalfEdges& from, Mesh& to) {
    to.first_corner.push_back(0);
    for (const auto f : from.faces()) {
        for (const auto v : from.fv_range(f))
            to.corner_position.push_back(static_cast<std::uint32_t>(v.idx()));
        to.first_corner.push_back(static_cast<std::uint32_t>(to.corner_position.size()));
    }
}

/// Subdivides positions and colours with the same weights.
template <class HalfEdges, class Subdivider> Mesh subdivided_by(const Mesh& mesh, int times) {
    const Fans fans = fans_of(mesh);
    Mesh out;
    {
        HalfEdges half_edges;
        Fans split = fans;
        add_faces(
            mesh, split, [&](std::uint32_t v) { return double_place(mesh.positions[v]); }, half_edges);
        subdivide<Subdivider>(half_edges, times);
        out.positions = places_in(half_edges);
        copy_faces(half_edges, out);
        warn(
            out.warnings, split.split_count,
            "vertex at an edge of three or more faces, or between several fans, was split by the subdivision",
            "vertices at an edge of three or more faces, or between several fans, were split by the "
            "subdivision");
    }
    if (!mesh.colors.empty()) {
        HalfEdges half_edges;
        Fans split = fans;
        add_faces(
            mesh, split, [&](std::uint32_t v) { return double_place(mesh.colors[v]); }, half_edges);
        subdivide<Subdivider>(half_edges, times);
        out.colors = places_in(half_edges);
    }
    return out;
}

}  // namespace

Mesh subdivided(const Mesh& mesh, int times) {
    const Mesh clean = without_repeated_corners(mesh);
    bool triangles = true;
    for (std::size_t f = 0; f < clean.face_count(); ++f)
        triangles = triangles && clean.corners_of(f).size() == 3;
    Mesh out = triangles ? subdivided_by<TriangleHalfEdges, LoopT<TriangleHalfEdges>>(clean, times)
                         : subdivided_by<PolygonHalfEdges, CatmullClarkT<PolygonHalfEdges>>(clean, times);
    out.warnings.insert(out.warnings.begin(), mesh.warnings.begin(), mesh.warnings.end());
    return out;
}

}  // namespace glint
