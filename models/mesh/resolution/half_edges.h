#pragma once
// Converts a mesh to OpenMesh's half-edges and back, inside models/mesh/resolution/ only. Where half-edges
// cannot hold the mesh (an edge of three faces, two fans at one vertex, ...), several of their vertices stand
// for one of the mesh.

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

/// Positions in double, because each of the many steps rounds.
struct DoublePlaces : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using TriangleHalfEdges = OpenMesh::TriMesh_ArrayKernelT<DoublePlaces>;
using PolygonHalfEdges = OpenMesh::PolyMesh_ArrayKernelT<DoublePlaces>;

/// Which vertex of the half-edges stands at each corner.
struct Fans {
    std::vector<std::uint32_t> corner;    // #C, indices into `position`
    std::vector<std::uint32_t> position;  // by vertex of the half-edges: index into Mesh::positions
    std::vector<char> is_split;           // #V of the mesh: several vertices stand for this one
    std::size_t split_count = 0;          // how many are
};
/// Gives each fan of faces a vertex of its own, so that only manifold edges are joined. Precondition: no
/// polygon has fewer than three corners or a vertex twice in a row.
[[nodiscard]] Fans fans_of(const Mesh& mesh);

/// The polygons that have three vertices and more, without corners that repeat the one before them.
[[nodiscard]] Mesh without_repeated_corners(const Mesh& mesh);
/// The mesh's triangles as polygons. Neither this mesh nor the one above is finished.
[[nodiscard]] Mesh triangles_of(const Mesh& mesh);

/// The most faces that meet at a vertex.
[[nodiscard]] std::size_t most_faces_around(const Mesh& mesh);

/// Adds the faces of `mesh`; a face that half-edges refuse gets vertices of its own, which are marked in
/// `fans`. `place(v)` returns the position of the mesh's vertex v.
template <class HalfEdges, class Place>
void add_faces(const Mesh& mesh, Fans& fans, const Place& place, HalfEdges& to) {
    using Handle = OpenMesh::VertexHandle;
    to.reserve(fans.position.size(), mesh.corner_position.size(), mesh.face_count());
    for (const std::uint32_t v : fans.position) to.add_vertex(place(v));
    std::vector<Handle> corners;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        corners.clear();
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c)
            corners.emplace_back(static_cast<int>(fans.corner[c]));
        std::vector<Handle> distinct = corners;
        std::sort(distinct.begin(), distinct.end());
        const bool holds = std::adjacent_find(distinct.begin(), distinct.end()) == distinct.end();
        if (holds && to.add_face(corners.data(), corners.size()).is_valid()) continue;
        for (Handle& corner : corners) {
            const std::uint32_t v = fans.position[static_cast<std::size_t>(corner.idx())];
            fans.split_count += fans.is_split[v] == 0 ? 1 : 0;
            fans.is_split[v] = 1;
            fans.position.push_back(v);
            corner = to.add_vertex(place(v));
        }
        to.add_face(corners.data(), corners.size());
    }
}

}  // namespace glint
