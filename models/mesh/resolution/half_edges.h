#pragma once
// Converts a mesh to OpenMesh's half-edges and back, inside models/mesh/resolution/ only. If half-edges
// cannot represent a vertex of the mesh (an edge of three faces, two fans at one vertex, ...), they have
// several vertices for it.

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

/// The vertex of the half-edges at each corner.
struct Fans {
    std::vector<std::uint32_t> corner;    // #C, indices into `position`
    std::vector<std::uint32_t> position;  // by vertex of the half-edges: index into Mesh::positions
    std::vector<char> is_split;           // #V of the mesh: has several vertices here
    std::size_t split_count = 0;          // the number of such vertices
};
/// Gives each fan of faces its own vertex, so that only manifold edges are joined. Precondition: no polygon
/// has fewer than three corners or a vertex twice in a row.
[[nodiscard]] Fans fans_of(const Mesh& mesh);

/// The polygons with at least three vertices, without corners that repeat the one before them.
[[nodiscard]] Mesh without_repeated_corners(const Mesh& mesh);
/// The mesh's triangles as polygons. Like the mesh above, the result is unfinished.
[[nodiscard]] Mesh triangles_of(const Mesh& mesh);

/// The maximum number of faces that meet at a vertex.
[[nodiscard]] std::size_t most_faces_around(const Mesh& mesh);

/// Adds the faces of `mesh`; a face that half-edges reject gets vertices of its own, which are marked in
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
