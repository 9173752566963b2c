#pragma once
// Makes a mesh finer or coarser than it was given: `subdivide` and `decimate` of the scene file.

#include <cstddef>
#include <cstdint>

#include "models/mesh/mesh.h"
#include "models/problem.h"

namespace glint {

/// How a mesh is changed: it is first decimated, then subdivided.
struct MeshResolution {
    int decimate = 0;   // triangles at most; 0: as many as there are
    int subdivide = 0;  // how many times each face is cut, 0 to max_subdivisions
    bool operator==(const MeshResolution&) const = default;
};

inline constexpr int max_subdivisions = 8, max_faces_wanted = 100'000'000;
/// Faces that subdividing may make: as many as the triangles of the finest primitives.
inline constexpr std::uint64_t max_subdivided_faces = std::uint64_t{1} << 23;
/// The most faces around a vertex, and corners of a face, of a mesh that is made finer or coarser: time grows
/// with their square.
inline constexpr std::size_t max_faces_around = 8192;

/// Whether the mesh stays as it is: it is not subdivided, and has no more triangles than are wanted.
[[nodiscard]] bool has_resolution(const Mesh& mesh, const MeshResolution& wanted);

/// Returns the mesh decimated, then subdivided: finished, and without given normals, because its surface is a
/// new one.
///
/// Decimation cuts polygons into triangles and removes vertices, least quadric error first (Garland and
/// Heckbert 1997); the others keep their position to the bit. A boundary keeps its shape: only its vertices
/// on a straight line are removed. Vertices where three or more faces meet at an edge, or two fans meet,
/// stay, and so do vertices with more than 48 faces around them. No triangle turns over. Where too few
/// vertices can be removed, a warning says how many triangles are left.
///
/// Subdivision is Loop's where all faces are triangles (each gives 4), else Catmull's and Clark's (a polygon
/// of n corners gives n quads). Where three or more faces meet at an edge, or two fans at a vertex, the faces
/// come apart, which a warning counts.
///
/// Precondition: has_resolution() is false. A problem's pointer is "/subdivide" or "/decimate", or empty.
/// Throws LoadCancelled (models/progress.h).
[[nodiscard]] Result<Mesh> with_resolution(const Mesh& mesh, const MeshResolution& wanted);

// The two steps of with_resolution(), for models/mesh/resolution/ only. Each appends its warnings to the
// mesh's.

/// Precondition: the mesh has more triangles than `triangles`, which is 1 or more.
[[nodiscard]] Mesh decimated(const Mesh& mesh, std::size_t triangles);
/// Precondition: times >= 1.
[[nodiscard]] Mesh subdivided(const Mesh& mesh, int times);

}  // namespace glint
