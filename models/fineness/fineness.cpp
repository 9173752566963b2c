#include "models/fineness/fineness.h"

#include <fmt/core.h>

#include <chrono>

#include "models/fineness/half_edges.h"
#include "models/memory_limit.h"

namespace glint {
namespace {

// Half-edges and their properties, in lists that grow, and the mesh itself; per face.
constexpr std::uint64_t bytes_a_face = 600;

/// Faces after that many steps: the first makes of each polygon as many as it has corners (of a triangle
/// among triangles 4), each further one 4 of each.
std::uint64_t faces_after(const Mesh& mesh, int steps) {
    const bool triangles = mesh.corner_position.size() == 3 * mesh.face_count();
    const std::uint64_t first = triangles ? 4 * mesh.face_count() : mesh.corner_position.size();
    return first << 2 * (steps - 1);
}

Problem too_many_around(std::size_t faces, const char* pointer) {
    return {"", pointer, fmt::format("{} faces meet at one vertex of the mesh", faces),
            fmt::format("at most {} where it is made finer or coarser", max_faces_around)};
}

}  // namespace

bool is_fine_as_it_is(const Mesh& mesh, const Fineness& wanted) {
    const bool few =
        wanted.decimate == 0 || mesh.triangles.size() <= static_cast<std::size_t>(wanted.decimate);
    return few && wanted.subdivide == 0;
}

Result<Mesh> with_fineness(const Mesh& mesh, const Fineness& wanted) {
    const auto start = std::chrono::steady_clock::now();
    const Mesh* from = &mesh;
    Mesh made;
    const std::size_t around = most_faces_around(mesh);
    if (!is_fine_as_it_is(mesh, {wanted.decimate, 0})) {
        if (around > max_faces_around) return too_many_around(around, "/decimate");
        const MemoryShare share(memory_need(MemoryUse::Meshes, bytes_a_face * mesh.triangles.size()));
        made = decimated(mesh, static_cast<std::size_t>(wanted.decimate));
        from = &made;
    }
    if (wanted.subdivide > 0) {
        if (around > max_faces_around) return too_many_around(around, "/subdivide");
        const std::uint64_t faces = faces_after(*from, wanted.subdivide);
        if (faces > max_subdivided_faces)
            return Problem{"", "/subdivide",
                           fmt::format("subdivided {} times the mesh has {} faces", wanted.subdivide, faces),
                           fmt::format("at most {}", max_subdivided_faces)};
        const MemoryShare share(memory_need(MemoryUse::Meshes, bytes_a_face * faces));
        made = subdivided(*from, wanted.subdivide);
    }
    finish_mesh(made);
    made.given_triangles = mesh.triangles.size();
    const auto time = std::chrono::steady_clock::now() - start;
    made.load_ms = mesh.load_ms + std::chrono::duration<double, std::milli>(time).count();
    return made;
}

}  // namespace glint
