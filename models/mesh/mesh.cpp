#include "models/mesh/mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "models/mesh/normals.h"
#include "models/mesh/polygon.h"
#include "models/mesh/topology.h"
#include "models/problem.h"
#include "models/progress.h"

namespace glint {
namespace {

// A corner takes up to about a thousand steps of ear clipping: a few milliseconds between two reports.
constexpr std::size_t corners_between_reports = 1 << 14;

Bounds bounds_of_faces(const Mesh& mesh) {
    if (mesh.corner_position.empty()) return {};
    Bounds bounds{mesh.positions[mesh.corner_position[0]], mesh.positions[mesh.corner_position[0]]};
    for (const std::uint32_t p : mesh.corner_position) {
        bounds.min = glm::min(bounds.min, mesh.positions[p]);
        bounds.max = glm::max(bounds.max, mesh.positions[p]);
    }
    return bounds;
}

}  // namespace

std::array<glm::dvec3, 8> corners_of(const Bounds& bounds) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1) != 0 ? bounds.max.x : bounds.min.x, (i & 2) != 0 ? bounds.max.y : bounds.min.y,
                      (i & 4) != 0 ? bounds.max.z : bounds.min.z};
    return corners;
}

std::optional<std::string> rounding_warning(const Bounds& bounds) {
    constexpr float fewest_steps = 1000;  // across; with fewer, each step is visible in a picture
    float farthest = 0, across = 0;
    for (int i = 0; i < 3; ++i) {
        farthest = std::max({farthest, std::abs(bounds.min[i]), std::abs(bounds.max[i])});
        across = std::max(across, bounds.max[i] - bounds.min[i]);
    }
    const float step = std::nextafter(farthest, HUGE_VALF) - farthest;
    if (!(across < fewest_steps * step) || farthest == 0) return {};
    return fmt::format(
        "the shape is {:.3g} across at coordinates of up to {:.7g}, which are rounded to steps of "
        "{:.3g}: it is drawn distorted, and may be too small to see; subtract an offset that moves it near "
        "the origin",
        across, farthest, step);
}

void finish_mesh(Mesh& mesh) {
    mesh.triangles.clear();
    if (mesh.corner_position.size() > 2 * mesh.face_count())
        mesh.triangles.reserve(mesh.corner_position.size() - 2 * mesh.face_count());
    Triangulator triangulator;
    RepeatedCorners repeated;
    std::vector<std::uint32_t> corners;
    std::size_t without_area = 0, repeating = 0, returning = 0, long_fans = 0;
    std::size_t next_report = corners_between_reports;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t first = mesh.first_corner[f], size = mesh.first_corner[f + 1] - first;
        if (first >= next_report) {
            report_or_leave(LoadStage::Building, f, mesh.face_count());
            next_report = first + corners_between_reports;
        }
        const PolygonPlane plane = polygon_plane(mesh, f);
        if (!(plane.area > 0)) {
            ++without_area;
        } else if (size == 3) {
            mesh.triangles.push_back({{first, first + 1, first + 2}, f});
        } else {
            distinct_corners(mesh, f, corners);
            repeating += corners.size() < size ? 1 : 0;
            returning += repeated.comes_back(mesh, corners) ? 1 : 0;
            long_fans += triangulator.cut(mesh, f, corners, plane.normal, mesh.triangles) ? 0 : 1;
        }
    }
    mesh.bounds = bounds_of_faces(mesh);
    warn(mesh.warnings, without_area, "degenerate face has no area and is not drawn",
         "degenerate faces have no area and are not drawn");
    warn(mesh.warnings, repeating, "face has a repeated corner, which was skipped",
         "faces have a repeated corner, which was skipped");
    warn(mesh.warnings, returning, "face visits one of its corners twice, and may be drawn wrong",
         "faces visit one of their corners twice, and may be drawn wrong");
    warn(mesh.warnings, long_fans, "face is not convex and has more than 1000 corners: drawn as a fan",
         "faces are not convex and have more than 1000 corners: drawn as fans");
}

namespace {

/// The vertices of a polygon in ascending order, without repetitions.
void vertex_set(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& set) {
    const auto corners = mesh.corners_of(face);
    set.assign(corners.begin(), corners.end());
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
}

/// Faces that have the vertices of an earlier one. Only sets with the same hash are compared.
std::size_t count_duplicates(const Mesh& mesh) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> by_hash(mesh.face_count());
    std::vector<std::uint32_t> set, other;
    for (std::uint32_t f = 0; f < by_hash.size(); ++f) {
        vertex_set(mesh, f, set);
        std::uint64_t hash = 0x9E3779B97F4A7C15u;
        for (const std::uint32_t v : set) {  // splitmix64, vertex by vertex
            hash = (hash ^ v) * 0xBF58476D1CE4E5B9u;
            hash = (hash ^ hash >> 27) * 0x94D049BB133111EBu;
            hash ^= hash >> 31;
        }
        by_hash[f] = {hash, f};
    }
    std::sort(by_hash.begin(), by_hash.end());
    std::size_t duplicates = 0;
    for (std::size_t i = 1; i < by_hash.size(); ++i) {
        if (by_hash[i].first != by_hash[i - 1].first) continue;
        vertex_set(mesh, by_hash[i - 1].second, other);
        vertex_set(mesh, by_hash[i].second, set);
        duplicates += set == other ? 1 : 0;
    }
    return duplicates;
}

void count_edges(const Mesh& mesh, MeshInfo& info) {
    const Topology topology = make_topology(mesh);
    info.edges = topology.edges.size();
    for (std::size_t e = 0; e < info.edges; ++e) {
        const EdgeKind kind = edge_kind(mesh, topology, e);
        info.boundary_edges += kind == EdgeKind::Boundary ? 1 : 0;
        info.inconsistent_edges += kind == EdgeKind::Inconsistent ? 1 : 0;
        info.non_manifold_edges += kind == EdgeKind::NonManifold ? 1 : 0;
    }
}

}  // namespace

MeshInfo mesh_info(const Mesh& mesh) {
    MeshInfo info;
    info.vertices = mesh.positions.size();
    info.faces = mesh.face_count();
    for (std::size_t f = 0; f < info.faces; ++f) {
        const std::size_t corners = mesh.corners_of(f).size();
        info.triangles += corners == 3 ? 1 : 0;
        info.quads += corners == 4 ? 1 : 0;
        info.polygons += corners >= 5 ? 1 : 0;
        info.degenerate_faces += polygon_plane(mesh, f).area > 0 ? 0 : 1;
    }
    count_edges(mesh, info);
    info.duplicate_faces = count_duplicates(mesh);
    info.bounds = mesh.bounds;
    info.warnings = mesh.warnings;
    warn_of_missing_normals(mesh, info.warnings);
    info.load_ms = mesh.load_ms;
    return info;
}

}  // namespace glint
