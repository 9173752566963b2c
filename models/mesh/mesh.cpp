#include "models/mesh/mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <set>
#include <utility>

#include "models/mesh/normals.h"
#include "models/mesh/polygon.h"
#include "models/problem.h"
#include "models/progress.h"

namespace glint {

Bounds bounds_of_faces(const Mesh& mesh) {
    if (mesh.corner_position.empty()) return {};
    Bounds bounds{mesh.positions[mesh.corner_position[0]], mesh.positions[mesh.corner_position[0]]};
    for (const std::uint32_t p : mesh.corner_position) {
        bounds.min = glm::min(bounds.min, mesh.positions[p]);
        bounds.max = glm::max(bounds.max, mesh.positions[p]);
    }
    return bounds;
}

std::array<glm::dvec3, 8> corners_of(const Bounds& bounds) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1) != 0 ? bounds.max.x : bounds.min.x, (i & 2) != 0 ? bounds.max.y : bounds.min.y,
                      (i & 4) != 0 ? bounds.max.z : bounds.min.z};
    return corners;
}

namespace {

/// The distance of the farthest coordinate, the longest side, and the step between floats at that distance.
struct Rounding {
    float farthest = 0, across = 0, step = 0;
    explicit Rounding(const Bounds& bounds) {
        for (int i = 0; i < 3; ++i) {
            farthest = std::max({farthest, std::abs(bounds.min[i]), std::abs(bounds.max[i])});
            across = std::max(across, bounds.max[i] - bounds.min[i]);
        }
        step = std::nextafter(farthest, HUGE_VALF) - farthest;
    }
};

}  // namespace

glm::dvec3 far_offset(const Bounds& bounds) {
    constexpr float fewest_steps = 1e5f, far_for_a_point = 1e4f;
    const Rounding now(bounds);
    if (!(now.across < fewest_steps * now.step) || (now.across == 0 && now.farthest < far_for_a_point))
        return {};
    const auto across = static_cast<double>(now.across);
    const double unit = across > 1 ? std::pow(10, std::floor(std::log10(across))) : 1;
    glm::dvec3 offset = (glm::dvec3(bounds.min) + glm::dvec3(bounds.max)) / 2.0;
    for (int i = 0; i < 3; ++i)
        offset[i] = std::abs(offset[i]) < across ? 0 : std::round(offset[i] / unit) * unit;
    return offset;
}

std::string offset_warning(const glm::dvec3& offset) {
    return fmt::format(
        "the coordinates are far from the origin: the offset ({:.0f}, {:.0f}, {:.0f}) is subtracted",
        offset.x, offset.y, offset.z);
}

std::optional<std::string> rounding_warning(const Bounds& bounds) {
    constexpr float fewest_steps = 1000;  // across the shape; with fewer, each step is visible
    const auto [farthest, across, step] = Rounding(bounds);
    if (!(across < fewest_steps * step) || farthest == 0) return {};
    return fmt::format(
        "the shape is {:.3g} across at coordinates of up to {:.7g}, which are rounded to steps of "
        "{:.3g}: it is drawn distorted, and may be too small to see; subtract an offset that moves it near "
        "the origin",
        across, farthest, step);
}

// The statistics of a mesh, and its findings.

namespace {

/// The vertices of a polygon in ascending order, without repetitions.
void vertex_set(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& set) {
    const auto corners = mesh.corners_of(face);
    set.assign(corners.begin(), corners.end());
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
}

/// Returns the faces that have the same vertices as an earlier face. Compares only faces with the same hash.
std::vector<std::uint32_t> duplicates_of(const Mesh& mesh) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> by_hash(mesh.face_count());
    std::vector<std::uint32_t> set, other, duplicates;
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
    for (std::size_t i = 1; i < by_hash.size(); ++i) {
        if (by_hash[i].first != by_hash[i - 1].first) continue;
        vertex_set(mesh, by_hash[i - 1].second, other);
        vertex_set(mesh, by_hash[i].second, set);
        if (set == other) duplicates.push_back(by_hash[i].second);
    }
    return duplicates;
}

/// Counts one kind of finding and collects its locations.
class Finding {
  public:
    Finding(std::string_view name, std::string_view effect) : found_{name, 0, "", effect, {}} {}

    void add(const glm::dvec3& place) {
        ++found_.count;
        if (found_.places.size() < MeshFinding::max_places) found_.places.emplace_back(place);
    }
    [[nodiscard]] std::size_t count() const { return found_.count; }
    /// Appends the finding unless the count is 0: "COUNT[ of TOTAL] one" or "... many".
    void add_to(MeshInfo& info, const char* one, const char* many, std::size_t total = 0) {
        if (found_.count == 0) return;
        const std::string of = total > 0 ? fmt::format(" of {}", total) : "";
        found_.what = fmt::format("{}{} {}", found_.count, of, found_.count == 1 && total == 0 ? one : many);
        info.findings.push_back(std::move(found_));
    }

  private:
    MeshFinding found_;
};

glm::dvec3 middle_of(const Mesh& mesh, std::size_t face) {
    glm::dvec3 sum(0);
    for (const std::uint32_t v : mesh.corners_of(face)) sum += glm::dvec3(mesh.positions[v]);
    return sum / std::max(static_cast<double>(mesh.corners_of(face).size()), 1.0);
}

void add_faces(const Mesh& mesh, MeshInfo& info) {
    Finding degenerate("degenerate_faces",
                       "they have no normal: lighting them divides by zero, and shows black or NaN");
    Finding duplicate("duplicate_faces",
                      "two faces in the same place flicker, and count twice in averaged normals");
    for (std::size_t f = 0; f < info.faces; ++f) {
        const std::size_t corners = mesh.corners_of(f).size();
        info.triangles += corners == 3 ? 1 : 0;
        info.quads += corners == 4 ? 1 : 0;
        info.polygons += corners >= 5 ? 1 : 0;
        if (!(polygon_plane(mesh, f).area > 0)) degenerate.add(middle_of(mesh, f));
    }
    for (const std::uint32_t f : duplicates_of(mesh)) duplicate.add(middle_of(mesh, f));
    info.degenerate_faces = degenerate.count();
    info.duplicate_faces = duplicate.count();
    degenerate.add_to(info, "face has no area", "faces have no area");
    duplicate.add_to(info, "face repeats another", "faces repeat another");
}

void add_edges(const Mesh& mesh, MeshInfo& info) {
    Finding opposite("opposite_winding", "culling leaves holes there, and averaged normals cancel");
    Finding open(
        "open_edges",
        "the back of the surface can be seen: it is missing with culling, and dark without two-sided light");
    Finding non_manifold("non_manifold_edges",
                         "averaged normals, subdivision and silhouettes are undefined there");
    const Topology topology = make_topology(mesh);
    info.edges = topology.edges.size();
    for (std::size_t e = 0; e < info.edges; ++e) {
        const auto& [a, b] = topology.edges[e];
        const glm::dvec3 middle = (glm::dvec3(mesh.positions[a]) + glm::dvec3(mesh.positions[b])) / 2.0;
        const EdgeKind kind = edge_kind(mesh, topology, e);
        if (kind == EdgeKind::Boundary) open.add(middle);
        if (kind == EdgeKind::Inconsistent) opposite.add(middle);
        if (kind == EdgeKind::NonManifold) non_manifold.add(middle);
    }
    info.boundary_edges = open.count();
    info.inconsistent_edges = opposite.count();
    info.non_manifold_edges = non_manifold.count();
    opposite.add_to(info, "edge joins faces that are wound in opposite directions",
                    "edges join faces that are wound in opposite directions");
    open.add_to(info, "edge is open", "edges are open", info.edges);
    non_manifold.add_to(info, "edge joins more than two faces", "edges join more than two faces");
}

void add_vertices(const Mesh& mesh, MeshInfo& info) {
    Finding unwelded("unwelded_vertices", "a program that averages normals by index shows a seam there");
    for (std::size_t v = 0; v < mesh.first_at_place.size(); ++v)
        if (mesh.first_at_place[v] != v) unwelded.add(mesh.positions[v]);
    unwelded.add_to(info, "vertex is at the position of another", "vertices are at the position of another",
                    info.vertices);
    if (!mesh.has_own_normal_indices) return;
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c)
        pairs.emplace(mesh.corner_position[c], mesh.given_normal_of(c));
    info.findings.push_back(
        {"own_normal_indices",
         pairs.size(),
         fmt::format("positions and normals have different indices: {} pairs of {} positions and {} normals",
                     pairs.size(), info.vertices, mesh.normals.size()),
         "a program with one index per corner must split vertices, or it uses the wrong normals",
         {}});
}

void add_normals(const Mesh& mesh, MeshInfo& info) {
    if (mesh.given_normals != GivenNormals::File) return;
    constexpr double unit_tolerance = 0.01;  // text files have few digits
    Finding against("normals_against_faces",
                    "they are lit from the wrong side: dark in the light, and bright in the shadow");
    Finding zero(
        "zero_normals",
        "normalizing them divides by zero, which shows black or NaN unless the normal is computed instead");
    Finding not_unit("non_unit_normals", "without normalizing, the light is too bright or too dark there");
    std::vector<char> seen(mesh.normals.size(), 0);
    for (std::size_t f = 0; f < info.faces; ++f) {
        const glm::dvec3 facet = polygon_plane(mesh, f).normal;
        bool is_against = false;
        for (std::size_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            const std::uint32_t given = mesh.given_normal_of(c);
            if (given == no_index) continue;
            const glm::dvec3 n(mesh.normals[given]);
            is_against = is_against || glm::dot(n, facet) < 0;
            if (std::exchange(seen[given], 1) != 0) continue;
            const glm::dvec3 place(mesh.positions[mesh.corner_position[c]]);
            if (n == glm::dvec3(0))
                zero.add(place);
            else if (std::abs(glm::length(n) - 1) > unit_tolerance)
                not_unit.add(place);
        }
        if (is_against) against.add(middle_of(mesh, f));
    }
    against.add_to(info, "face has a normal that points the opposite way",
                   "faces have normals that point the opposite way", info.faces);
    if (mesh.bad_normals > 0)  // they are now zero normals, whose finding lists the places
        info.findings.push_back(
            {"invalid_normals",
             mesh.bad_normals,
             fmt::format("{} of {} normals are not finite", mesh.bad_normals, mesh.normals.size()),
             "the light at their corners is NaN, which shows black, white or nothing",
             {}});
    zero.add_to(info, "normal is zero or missing", "normals are zero or missing", mesh.normals.size());
    not_unit.add_to(info, "normal does not have length 1", "normals do not have length 1",
                    mesh.normals.size());
}

/// Hints about units, and about a shape that rotates about a distant origin.
void add_size(const Mesh& mesh, MeshInfo& info) {
    // `smallest` and `largest` in scene units, `farthest` in multiples of the shape's size.
    constexpr double smallest = 0.01, largest = 1000, farthest = 3;
    const glm::dvec3 low(mesh.bounds.min), high(mesh.bounds.max);
    const double size = glm::length(high - low), distance = glm::length((low + high) / 2.0 + mesh.offset);
    if (size > 0 && (size < smallest || size > largest))
        info.findings.push_back(
            {"size",
             1,
             fmt::format("the shape is {:.3g} units in size", size),
             "the file may use other units: near and far planes and falloffs meant for metres do not fit",
             {}});
    if (size > 0 && distance > farthest * size)
        info.findings.push_back(
            {"far_from_origin",
             1,
             fmt::format("the shape is {:.7g} units from the origin and {:.3g} in size", distance, size),
             "rotating the object moves it out of view, and rounding to floats distorts its shape",
             {}});
}

}  // namespace

MeshInfo mesh_info(const Mesh& mesh) {
    MeshInfo info;
    info.vertices = mesh.positions.size();
    info.faces = mesh.face_count();
    add_normals(mesh, info);
    add_edges(mesh, info);
    add_faces(mesh, info);
    add_vertices(mesh, info);
    add_size(mesh, info);
    info.bounds = mesh.bounds;
    info.offset = mesh.offset;
    info.warnings = mesh.warnings;
    warn_of_missing_normals(mesh, info.warnings);
    info.load_ms = mesh.load_ms;
    return info;
}

namespace {

/// A side of a polygon: the two vertices, the smaller first, and its polygon.
struct Side {
    std::array<std::uint32_t, 2> edge;
    EdgeUse use;
};

/// All sides of polygons, sorted by their edge and their corner.
std::vector<Side> sorted_sides(const Mesh& mesh) {
    std::vector<Side> sides, sorted;
    sides.reserve(mesh.corner_position.size());
    std::vector<std::uint32_t> end(mesh.positions.size() + 1, 0);  // by smaller vertex: the end of its sides
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            const std::uint32_t a = mesh.place_of(c), b = mesh.place_of(next_corner(mesh, f, c));
            if (a == b) continue;
            sides.push_back({{std::min(a, b), std::max(a, b)}, {f, c}});
            ++end[std::min(a, b) + 1];
        }
    std::partial_sum(end.begin(), end.end(), end.begin());
    sorted.resize(sides.size());
    for (const Side& side : sides) sorted[end[side.edge[0]]++] = side;
    for (std::size_t v = 0, from = 0; v < mesh.positions.size(); from = end[v++])
        std::sort(sorted.begin() + std::ptrdiff_t(from), sorted.begin() + std::ptrdiff_t(end[v]),
                  [](const Side& x, const Side& y) {
                      return x.edge[1] != y.edge[1] ? x.edge[1] < y.edge[1] : x.use.corner < y.use.corner;
                  });
    return sorted;
}

}  // namespace

Topology make_topology(const Mesh& mesh) {
    const std::vector<Side> sides = sorted_sides(mesh);
    const auto begins_edge = [&sides](std::size_t s) { return s == 0 || sides[s].edge != sides[s - 1].edge; };
    // For each corner that begins an edge, the index of the edge's first side.
    std::vector<std::uint32_t> first_side(mesh.corner_position.size(), no_index);
    for (std::size_t s = 0; s < sides.size(); ++s)
        if (begins_edge(s)) first_side[sides[s].use.corner] = static_cast<std::uint32_t>(s);
    Topology t;
    t.uses.reserve(sides.size());
    for (std::size_t s : first_side) {
        if (s == no_index) continue;
        t.edges.push_back(sides[s].edge);
        t.first_use.push_back(static_cast<std::uint32_t>(t.uses.size()));
        do t.uses.push_back(sides[s++].use);
        while (s < sides.size() && !begins_edge(s));
    }
    t.first_use.push_back(static_cast<std::uint32_t>(t.uses.size()));
    return t;
}

EdgeKind edge_kind(const Mesh& mesh, const Topology& topology, std::size_t edge) {
    const auto uses = topology.uses_of(edge);
    if (uses.size() == 1) return EdgeKind::Boundary;
    if (uses.size() > 2) return EdgeKind::NonManifold;
    const bool same = mesh.place_of(uses[0].corner) == mesh.place_of(uses[1].corner);
    return same ? EdgeKind::Inconsistent : EdgeKind::Manifold;
}

}  // namespace glint
