#pragma once
// A polygon mesh as given. Polygons of any size are kept (for flat shading and silhouettes) and cut into
// triangles for rasterization. Nothing is merged, dropped or reordered, so a face number means the same here,
// in the file and in `glint explain`. Immutable once created; shared by pointer-to-const.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/problem.h"

namespace glint {

inline constexpr std::uint32_t no_index = 0xFFFFFFFFu;

/// The origin of a mesh's normals.
enum class GivenNormals { None, File, Analytic };

/// Three corners of one polygon, counter-clockwise seen from outside in the file's orientation. Within a fan
/// the triangle is (first, i, i + 1): its last corner is OpenGL's provoking vertex.
struct Triangle {
    std::array<std::uint32_t, 3> corner;  // indices into Mesh::corner_position
    std::uint32_t face;
    bool operator==(const Triangle&) const = default;
};

struct Bounds {
    glm::vec3 min{0}, max{0};
    bool operator==(const Bounds&) const = default;
};
/// Returns the corners; x changes fastest, then y.
[[nodiscard]] std::array<glm::dvec3, 8> corners_of(const Bounds& bounds);

struct Mesh {
    std::vector<glm::vec3> positions;         // #V, object coordinates, scene units; unused ones are kept
    std::vector<std::uint32_t> first_corner;  // #F + 1: polygon f has the corners first_corner[f] .. [f + 1)
    std::vector<std::uint32_t> corner_position;  // #C, indices into positions, in the file's order
    GivenNormals given_normals = GivenNormals::None;
    std::vector<glm::vec3> normals;  // as given (a file's may not be normalized), object coordinates
    std::vector<std::uint32_t> corner_normal;  // #C, indices into normals or no_index; empty: corner c has
                                               // (when normals are given) normals[corner_position[c]]
    std::vector<glm::vec3> colors;             // #V, linear RGB; empty if the file has none
    // #F, the smoothing group of each face: normals are averaged within a group, and not at all in group 0.
    // Empty: all faces are in one group.
    std::vector<std::uint32_t> smoothing;
    // #V, the first vertex at each vertex's position, over which normals are averaged and edges are joined.
    // Empty: no two vertices share a position.
    std::vector<std::uint32_t> first_at_place;
    std::vector<Triangle> triangles;      // in face order; none for degenerate polygons
    Bounds bounds;                        // bounds of the positions that faces use
    Warnings warnings;                    // about input that was tolerated while reading and cutting
    glm::dvec3 offset{0};                 // subtracted from the file's coordinates, which were far away
    std::size_t bad_normals = 0;          // the number of non-finite normals, which are now 0
    bool has_own_normal_indices = false;  // the file has separate indices for normals and positions
    double load_ms = 0;                   // time taken to read or make the mesh
    std::size_t given_triangles = 0;      // in the original of a refined or coarsened mesh
                                          // (models/mesh/resolution/resolution.h); 0: this is the original

    [[nodiscard]] std::size_t face_count() const {
        return first_corner.empty() ? 0 : first_corner.size() - 1;
    }
    /// The indices into `positions` around polygon f, in the file's order.
    [[nodiscard]] std::span<const std::uint32_t> corners_of(std::size_t f) const {
        return std::span(corner_position).subspan(first_corner[f], first_corner[f + 1] - first_corner[f]);
    }
    /// The first vertex at the position of a corner.
    [[nodiscard]] std::uint32_t place_of(std::size_t corner) const {
        const std::uint32_t v = corner_position[corner];
        return first_at_place.empty() ? v : first_at_place[v];
    }
    /// The index into `normals` of a corner's normal as given, or no_index. Precondition: normals are given.
    [[nodiscard]] std::uint32_t given_normal_of(std::size_t corner) const {
        return corner_normal.empty() ? corner_position[corner] : corner_normal[corner];
    }
};

using MeshPtr = std::shared_ptr<const Mesh>;

/// The maximum size of a mesh file, and the maximum total size of all files that one mesh file names.
inline constexpr std::size_t max_mesh_file_bytes = std::size_t{2} << 30;

/// Returns the bounds of the positions that faces use.
[[nodiscard]] Bounds bounds_of_faces(const Mesh& mesh);

/// An offset, in whole units, that moves a shape near the origin if it is so far away that floats have fewer
/// than 100,000 steps across it; else 0.
[[nodiscard]] glm::dvec3 far_offset(const Bounds& bounds);
/// The warning about an offset that was subtracted.
[[nodiscard]] std::string offset_warning(const glm::dvec3& offset);

/// Returns a warning if a shape is so small, and so far from the origin, that the rounding of its coordinates
/// to floats is visible; otherwise nullopt.
[[nodiscard]] std::optional<std::string> rounding_warning(const Bounds& bounds);

/// Fills in triangles and bounds from the polygon list: convex polygons as a fan from the first corner,
/// others by ear clipping (above 1000 corners as a fan, with a warning). A corner that repeats the one before
/// it is skipped with a warning. A polygon that returns to an earlier corner gets a warning as well, unless a
/// bridge joins its outline to a hole there. Polygons with fewer than three distinct corners or no area keep
/// their number but yield no triangle; a warning states their count. Every triangle has a non-zero area.
/// Reports the load's progress; throws LoadCancelled (models/progress.h) when this thread's load is
/// cancelled.
void finish_mesh(Mesh& mesh);

/// A property of a mesh that some programs draw incorrectly.
struct MeshFinding {
    static constexpr std::size_t max_places = 1000;
    std::string_view name;  // "unwelded_vertices", for JSON
    std::size_t count = 0;
    std::string what;               // "2 of 6 faces have normals that point the opposite way"
    std::string_view effect;        // what such a program draws incorrectly
    std::vector<glm::vec3> places;  // object coordinates; at most max_places; empty for the entire shape
};

/// The statistics of `glint info`. Counts refer to the file's contents, before any repair.
struct MeshInfo {
    std::size_t vertices = 0, faces = 0, triangles = 0, quads = 0,
                polygons = 0;            // polygons: 5 or more corners
    std::size_t edges = 0;               // pairs of different vertices that are consecutive in a polygon
    std::size_t boundary_edges = 0;      // edges that one polygon uses once
    std::size_t non_manifold_edges = 0;  // edges of more than two polygons
    std::size_t inconsistent_edges = 0;  // edges traversed twice in one direction: one winding is wrong
    std::size_t degenerate_faces = 0;    // faces with fewer than three distinct corners or no area
    std::size_t duplicate_faces = 0;     // faces with the same vertices as an earlier one, in any order
    Bounds bounds;
    glm::dvec3 offset{0};
    std::vector<MeshFinding> findings;
    Warnings warnings;
    double load_ms = 0;
};
[[nodiscard]] MeshInfo mesh_info(const Mesh& mesh);

// Finds the polygons that meet at each edge, however many. Built from the polygon list on demand (for
// counting, creases, silhouettes), never for plain drawing.

/// Polygon `face` runs along an edge from `corner` to next_corner(mesh, face, corner).
struct EdgeUse {
    std::uint32_t face, corner;
    bool operator==(const EdgeUse&) const = default;
};

struct Topology {
    std::vector<std::array<std::uint32_t, 2>>
        edges;                             // #E, indices of places, the smaller first; each pair once
    std::vector<std::uint32_t> first_use;  // #E + 1: edge e has the uses first_use[e] .. [e + 1)
    std::vector<EdgeUse> uses;             // every side of every polygon that joins two vertices

    [[nodiscard]] std::span<const EdgeUse> uses_of(std::size_t e) const {
        return std::span(uses).subspan(first_use[e], first_use[e + 1] - first_use[e]);
    }
};

/// Finds the edges between places (Mesh::place_of()), in the order of their first corners. Degenerate
/// polygons are included; a side from a place to itself is not an edge. Time: about linear, at most n log n.
[[nodiscard]] Topology make_topology(const Mesh& mesh);

/// The corner after `corner` around polygon `face`; the first corner after the last one.
[[nodiscard]] inline std::uint32_t next_corner(const Mesh& mesh, std::uint32_t face, std::uint32_t corner) {
    return corner + 1 < mesh.first_corner[face + 1] ? corner + 1 : mesh.first_corner[face];
}

enum class EdgeKind {
    Boundary,      // belongs to one polygon, once
    Manifold,      // two sides that run in opposite directions
    Inconsistent,  // two sides that run in the same direction: one polygon has the opposite winding
    NonManifold    // three or more sides
};
[[nodiscard]] EdgeKind edge_kind(const Mesh& mesh, const Topology& topology, std::size_t edge);

}  // namespace glint
