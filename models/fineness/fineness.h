#pragma once
// Makes a mesh finer or coarser than it was given: `subdivide` and `decimate` of the scene file.

#include <cstddef>
#include <cstdint>

#include "models/mesh/mesh.h"
#include "models/problem.h"

namespace glint {

/// What is made of a mesh: first the one, then the other.
struct Fineness {
    int decimate = 0;   // triangles at most; 0: as many as there are
    int subdivide = 0;  // how many times each face is cut, 0 to max_subdivisions
    bool operator==(const Fineness&) const = default;
};

inline constexpr int max_subdivisions = 8, max_faces_wanted = 100'000'000;
/// Faces that subdividing may make: as many as the triangles of the finest primitives.
inline constexpr std::uint64_t max_subdivided_faces = std::uint64_t{1} << 23;
/// Faces around one vertex of a mesh that is made finer or coarser: each looks at its neighbours there.
inline constexpr std::size_t max_faces_around = 8192;

/// Whether the mesh stays as it is: it is not subdivided, and has no more triangles than are wanted.
[[nodiscard]] bool is_fine_as_it_is(const Mesh& mesh, const Fineness& wanted);

/// The mesh made coarser, then finer; finished, without normals of its own (its surface is another).
///
/// Decimating cuts polygons into triangles and takes vertices away, the least quadric error first (Garland
/// and Heckbert 1997); those that stay keep their place to the bit. A boundary keeps its shape: of its
/// vertices only those go that lie on a straight line. Where three faces and more meet at an edge, or two
/// fans at a vertex, nothing goes. No triangle turns over. Where too few may go, a warning says how many are
/// left.
///
/// Subdividing is Loop's where all faces are triangles (4 of each), else Catmull's and Clark's (a polygon of
/// n corners gives n quads, a quad 4). Where three faces and more meet at an edge, or two fans at a vertex,
/// the faces come apart, which a warning counts.
///
/// Precondition: is_fine_as_it_is() is false. A problem's pointer is "/subdivide" or "/decimate", or empty.
/// Throws LoadCancelled (models/progress.h) and Refused (models/memory_limit.h).
[[nodiscard]] Result<Mesh> with_fineness(const Mesh& mesh, const Fineness& wanted);

// Its two steps, inside models/fineness/ only. Each appends its warnings to the mesh's.

/// Precondition: the mesh has more triangles than `triangles`, which is 1 or more.
[[nodiscard]] Mesh decimated(const Mesh& mesh, std::size_t triangles);
/// Precondition: times >= 1.
[[nodiscard]] Mesh subdivided(const Mesh& mesh, int times);

}  // namespace glint
