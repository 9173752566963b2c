#include "models/mesh/resolution/resolution.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "models/mesh/resolution/half_edges.h"

namespace glint {
namespace {

/// The number of faces after that many steps: the first step gives one face per corner of a polygon (4 per
/// triangle if all are triangles), each further step 4 per face.
std::uint64_t faces_after(const Mesh& mesh, int steps) {
    const bool triangles = mesh.corner_position.size() == 3 * mesh.face_count();
    const std::uint64_t first = triangles ? 4 * mesh.face_count() : mesh.corner_position.size();
    return first << 2 * (steps - 1);
}

/// The largest number of corners of a face: subdividing makes this many faces meet at its centre.
std::size_t most_corners(const Mesh& mesh) {
    std::size_t most = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        most = std::max<std::size_t>(most, mesh.first_corner[f + 1] - mesh.first_corner[f]);
    return most;
}

std::optional<Problem> too_many_around(const Mesh& mesh, const char* pointer) {
    const std::size_t faces = most_faces_around(mesh), corners = most_corners(mesh);
    if (std::max(faces, corners) <= max_faces_around) return std::nullopt;
    return Problem{"", pointer,
                   faces > max_faces_around ? fmt::format("{} faces meet at one vertex of the mesh", faces)
                                            : fmt::format("a face of the mesh has {} corners", corners),
                   fmt::format("at most {} for another resolution", max_faces_around)};
}

}  // namespace

bool has_resolution(const Mesh& mesh, const MeshResolution& wanted) {
    const bool few =
        wanted.decimate == 0 || mesh.triangles.size() <= static_cast<std::size_t>(wanted.decimate);
    return few && wanted.subdivide == 0;
}

Result<Mesh> with_resolution(const Mesh& mesh, const MeshResolution& wanted) {
    const auto start = std::chrono::steady_clock::now();
    const Mesh* from = &mesh;
    Mesh made;
    if (!has_resolution(mesh, {wanted.decimate, 0})) {
        if (const auto problem = too_many_around(mesh, "/decimate")) return *problem;
        made = decimated(mesh, static_cast<std::size_t>(wanted.decimate));
        from = &made;
    }
    if (wanted.subdivide > 0) {
        if (const auto problem = too_many_around(mesh, "/subdivide")) return *problem;
        const std::uint64_t faces = faces_after(*from, wanted.subdivide);
        if (faces > max_subdivided_faces)
            return Problem{"", "/subdivide",
                           fmt::format("subdivided {} times the mesh has {} faces", wanted.subdivide, faces),
                           fmt::format("at most {}", max_subdivided_faces)};
        made = subdivided(*from, wanted.subdivide);
    }
    finish_mesh(made);
    made.given_triangles = mesh.triangles.size();
    const auto time = std::chrono::steady_clock::now() - start;
    made.load_ms = mesh.load_ms + std::chrono::duration<double, std::milli>(time).count();
    return made;
}

}  // namespace glint
