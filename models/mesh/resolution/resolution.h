#pragma once
// Refines or coarsens a mesh: `subdivide` and `decimate` of the scene file.

#include <cstddef>
#include <cstdint>

#include "models/mesh/mesh.h"
#include "models/problem.h"

namespace glint {

/// The changes to a mesh: it is first decimated, then subdivided.
struct MeshResolution {
    int decimate = 0;   // maximum number of triangles; 0: unchanged
    int subdivide = 0;  // how many times each face is subdivided, 0 to max_subdivisions
    bool operator==(const MeshResolution&) const = default;
};

inline constexpr int max_subdivisions = 8, max_faces_wanted = 100'000'000;
/// The limit on the number of faces after subdivision: the number of triangles of the finest primitives.
inline constexpr std::uint64_t max_subdivided_faces = std::uint64_t{1} << 23;
/// The limit on faces around a vertex, and on corners of a face, in a mesh that is refined or coarsened: the
/// time grows with their square.
inline constexpr std::size_t max_faces_around = 8192;

/// Whether the mesh needs no change: no subdivision is requested, and it has no more triangles than
/// requested.
[[nodiscard]] bool has_resolution(const Mesh& mesh, const MeshResolution& wanted);

/// Returns the decimated, then subdivided mesh. It is finished, and has no given normals, because its surface
/// is new.
///
/// Decimation cuts polygons into triangles and removes vertices, smallest quadric error first (Garland and
/// Heckbert 1997); the other vertices keep their exact positions. A boundary keeps its shape: only its
/// vertices on a straight line are removed. Vertices stay where three or more faces share an edge, where two
/// fans meet, or where more than 48 faces meet. No triangle flips. If too few vertices can be removed, a
/// warning reports the number of triangles left.
///
/// Subdivision is Loop's if all faces are triangles (each yields 4), else Catmull-Clark (a polygon of n
/// corners yields n quads). If three or more faces share an edge, or two fans a vertex, the faces separate
/// there; a warning counts these vertices.
///
/// Precondition: has_resolution() is false. A problem's pointer is "/subdivide" or "/decimate", or empty.
/// Throws LoadCancelled (models/progress.h).
[[nodiscard]] Result<Mesh> with_resolution(const Mesh& mesh, const MeshResolution& wanted);

}  // namespace glint
