#include "models/mesh/resolution/resolution.h"

#include <fmt/core.h>

// clang-format off
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
// These headers require the mesh types above.
#include <OpenMesh/Core/Geometry/QuadricT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
// clang-format on
#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/mesh/normals.h"
#include "models/progress.h"

namespace glint {
namespace {

// OpenMesh's half-edges. Where they cannot represent a vertex of the mesh (three faces at an edge, two fans
// at a vertex, ...), several half-edge vertices represent it.

/// Positions in double, because the rounding errors of many steps accumulate.
struct DoublePlaces : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using TriangleHalfEdges = OpenMesh::TriMesh_ArrayKernelT<DoublePlaces>;
using PolygonHalfEdges = OpenMesh::PolyMesh_ArrayKernelT<DoublePlaces>;

/// The half-edge vertex at each corner.
struct Fans {
    std::vector<std::uint32_t> corner;    // #C, indices into `position`
    std::vector<std::uint32_t> position;  // for each half-edge vertex, an index into Mesh::positions
    std::vector<char> is_split;           // #V of the mesh: the vertex has several half-edge vertices
    std::size_t split_count = 0;          // the number of vertices marked in is_split
};
/// Gives each fan of faces its own vertex, so that only manifold edges are joined. Precondition: no polygon
/// has fewer than three corners or a vertex twice in a row.
Fans fans_of(const Mesh& mesh) {
    static const bool silent = (::omerr().disable(), true);  // OpenMesh prints every face that it rejects
    static_cast<void>(silent);
    CreaseGroups groups = crease_groups(mesh, make_topology(mesh), 180);
    Fans fans;
    fans.position.resize(groups.count);
    fans.is_split.resize(mesh.positions.size(), 0);
    std::vector<std::uint32_t> first(mesh.positions.size(), no_index);
    for (std::size_t c = 0; c < groups.group.size(); ++c) {
        const std::uint32_t v = mesh.corner_position[c], fan = groups.group[c];
        fans.position[fan] = v;
        if (first[v] == no_index) first[v] = fan;
        if (first[v] == fan || fans.is_split[v] != 0) continue;
        fans.is_split[v] = 1;
        ++fans.split_count;
    }
    fans.corner = std::move(groups.group);
    return fans;
}

/// An unfinished mesh with the vertices of another mesh and no faces.
Mesh with_vertices_of(const Mesh& mesh) {
    Mesh out;
    out.positions = mesh.positions;
    out.colors = mesh.colors;
    out.first_corner.push_back(0);
    return out;
}

/// Adds a polygon, skipping vertices that repeat the one before them. Adds nothing if fewer than three are
/// left.
void add_polygon(Mesh& to, std::span<const std::uint32_t> vertices) {
    const std::size_t begin = to.corner_position.size();
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (vertices[i] != vertices[(i + 1) % vertices.size()]) to.corner_position.push_back(vertices[i]);
    if (to.corner_position.size() < begin + 3)
        to.corner_position.resize(begin);
    else
        to.first_corner.push_back(static_cast<std::uint32_t>(to.corner_position.size()));
}

/// The maximum number of faces that meet at a vertex.
std::size_t most_faces_around(const Mesh& mesh) {
    std::vector<std::size_t> faces(mesh.positions.size(), 0);
    for (const std::uint32_t v : mesh.corner_position) ++faces[v];
    return faces.empty() ? 0 : *std::max_element(faces.begin(), faces.end());
}

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

// Subdivision: C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987; E. Catmull and J. Clark,
// "Recursively generated B-spline surfaces on arbitrary topological meshes", 1978.

using OpenMesh::Subdivider::Uniform::CatmullClarkT;
using OpenMesh::Subdivider::Uniform::LoopT;

OpenMesh::Vec3d double_place(const glm::vec3& v) { return {double(v.x), double(v.y), double(v.z)}; }
glm::vec3 float_place(const OpenMesh::Vec3d& v) { return {float(v[0]), float(v[1]), float(v[2])}; }

/// Returns the positions of the boundary vertices after one subdivision step. In both schemes a boundary is a
/// cubic B-spline: a step moves v, with neighbours a and b on the boundary, to (a + 6 v + b) / 8. OpenMesh
/// 9.0 does this in Loop's scheme. In the Catmull-Clark scheme it uses (a + 4 v + b) / 6, the limit of
/// infinitely many steps.
template <class HalfEdges> auto boundary_places(const HalfEdges& mesh) {
    std::vector<std::pair<OpenMesh::VertexHandle, OpenMesh::Vec3d>> places;
    for (const auto v : mesh.vertices()) {
        if (!mesh.is_boundary(v)) continue;
        const auto out = mesh.halfedge_handle(v);  // at a boundary vertex it runs along the boundary
        if (!out.is_valid()) continue;
        const auto a = mesh.to_vertex_handle(out),
                   b = mesh.from_vertex_handle(mesh.prev_halfedge_handle(out));
        places.emplace_back(v, (mesh.point(a) + 6.0 * mesh.point(v) + mesh.point(b)) / 8.0);
    }
    return places;
}

/// Returns the largest valence, at least the six of a new vertex. OpenMesh 9.0 precomputes the weights of
/// Loop's scheme up to valence 49, and reads beyond its table for more.
template <class HalfEdges> std::size_t most_neighbours(const HalfEdges& mesh) {
    std::size_t most = 6;
    for (const auto v : mesh.vertices()) most = std::max<std::size_t>(most, mesh.valence(v));
    return most;
}

/// Runs one step at a time, because a load may be cancelled between steps.
template <class Subdivider, class HalfEdges> void subdivide(HalfEdges& mesh, int times) {
    Subdivider subdivider;
    if constexpr (requires { subdivider.init_weights(); }) subdivider.init_weights(most_neighbours(mesh) + 1);
    for (int step = 0; step < times; ++step) {
        report_or_leave(LoadStage::Building, mesh.n_faces());
        const auto boundary = boundary_places(mesh);
        subdivider(mesh, 1);
        for (const auto& [vertex, place] : boundary)
            mesh.set_point(vertex, place);  // a step keeps the vertices' numbers
    }
}

template <class HalfEdges> std::vector<glm::vec3> places_in(const HalfEdges& mesh) {
    std::vector<glm::vec3> places;
    places.reserve(mesh.n_vertices());
    for (const auto v : mesh.vertices()) places.push_back(float_place(mesh.point(v)));
    return places;
}

template <class HalfEdges> void copy_faces(const HalfEdges& from, Mesh& to) {
    to.first_corner.push_back(0);
    for (const auto f : from.faces()) {
        for (const auto v : from.fv_range(f))
            to.corner_position.push_back(static_cast<std::uint32_t>(v.idx()));
        to.first_corner.push_back(static_cast<std::uint32_t>(to.corner_position.size()));
    }
}

/// Subdivides positions and colours with the same weights.
template <class HalfEdges, class Subdivider> Mesh subdivided_by(const Mesh& mesh, int times) {
    const Fans fans = fans_of(mesh);
    Mesh out;
    const auto values_of = [&](const std::vector<glm::vec3>& values, bool with_faces) {
        HalfEdges half_edges;
        Fans split = fans;
        add_faces(
            mesh, split, [&](std::uint32_t v) { return double_place(values[v]); }, half_edges);
        subdivide<Subdivider>(half_edges, times);
        if (with_faces) {
            copy_faces(half_edges, out);
            warn(out.warnings, split.split_count,
                 "vertex at an edge of three or more faces, or between several fans, was split by the "
                 "subdivision",
                 "vertices at an edge of three or more faces, or between several fans, were split by the "
                 "subdivision");
        }
        return places_in(half_edges);
    };
    out.positions = values_of(mesh.positions, true);
    if (!mesh.colors.empty()) out.colors = values_of(mesh.colors, false);
    return out;
}

/// Precondition: times >= 1. Like decimated(), appends its warnings to those of the mesh.
Mesh subdivided(const Mesh& mesh, int times) {
    Mesh clean = with_vertices_of(mesh);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) add_polygon(clean, mesh.corners_of(f));
    bool triangles = true;
    for (std::size_t f = 0; f < clean.face_count(); ++f)
        triangles = triangles && clean.corners_of(f).size() == 3;
    Mesh out = triangles ? subdivided_by<TriangleHalfEdges, LoopT<TriangleHalfEdges>>(clean, times)
                         : subdivided_by<PolygonHalfEdges, CatmullClarkT<PolygonHalfEdges>>(clean, times);
    out.warnings.insert(out.warnings.begin(), mesh.warnings.begin(), mesh.warnings.end());
    return out;
}

// Decimation: M. Garland and P. Heckbert, "Surface simplification using quadric error metrics", 1997.

using HalfEdges = TriangleHalfEdges;
using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec3d;
using OpenMesh::VertexHandle;
using Quadric = OpenMesh::Geometry::QuadricT<double>;

// Vertices with more faces around them are not removed, because each change around a vertex causes it to be
// examined again.
constexpr unsigned most_around = 48;
// The sine of the turning angle below which a boundary counts as straight at a vertex.
constexpr double straight_boundary = 1e-6;
// The cosine of the largest rotation of a face in one step, 78 degrees, so that a flat area cannot fold over.
constexpr double least_turn = 0.2;
// Twice a triangle's area over the square of its longest side; a triangle below this ratio is a needle.
constexpr double least_height = 1e-3;
constexpr std::size_t between_reports = 1024;

/// Collapses vertices, each onto a neighbour, smallest quadric error first. OpenMesh's own decimater tests
/// all collapses of every vertex around a change; this one tests only those of the next vertex in the queue,
/// which takes a fifth of the time.
class Collapses {
  public:
    explicit Collapses(HalfEdges& mesh) : m_(mesh), quadric_(mesh.n_vertices()), turn_(mesh.n_vertices(), 0) {
        for (Quadric& q : quadric_) q.clear();
        for (const auto f : m_.faces()) add_plane(f);
        for (const auto v : m_.vertices()) enqueue(v);
    }

    void run(std::size_t wanted_faces) {
        std::size_t faces = m_.n_faces();
        for (std::size_t steps = 0; faces > wanted_faces && !queue_.empty(); ++steps) {
            if (steps % between_reports == 0) report_or_leave(LoadStage::Building, faces);
            const Waiting next = queue_.top();
            queue_.pop();
            if (next.turn != turn_[next.vertex]) continue;  // its neighbourhood has changed in the meantime
            const Step step = best(VertexHandle(static_cast<int>(next.vertex)), true);
            if (!step.way.is_valid()) continue;
            if (step.error > next.error)
                queue_.push({step.error, next.vertex, next.turn});
            else
                faces -= take(step.way);
        }
    }

  private:
    struct Waiting {
        double error;
        std::size_t vertex;
        std::uint32_t turn;
        bool operator<(const Waiting& o) const {  // std::priority_queue starts with the largest
            return error != o.error ? error > o.error : vertex > o.vertex;
        }
    };
    struct Step {
        double error = 0;
        HalfedgeHandle way = HalfedgeHandle();  // from the removed vertex to the remaining one
    };
    static std::size_t number(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

    void add_plane(OpenMesh::FaceHandle f) {
        std::array<VertexHandle, 3> corner;
        std::size_t i = 0;
        for (const auto v : m_.fv_range(f)) corner[i++] = v;
        const Vec3d across =
            (m_.point(corner[1]) - m_.point(corner[0])) % (m_.point(corner[2]) - m_.point(corner[0]));
        const double length = across.norm();
        if (!(length > 0)) return;
        const Vec3d n = across / length;
        Quadric q(n[0], n[1], n[2], -(n | m_.point(corner[0])));
        q *= length / 2;
        for (const VertexHandle v : corner) quadric_[number(v)] += q;
    }

    /// Returns the collapse of v with the smallest error; if `checked`, only among the allowed ones.
    Step best(VertexHandle v, bool checked) {
        ways_.clear();
        for (const auto h : m_.voh_range(v)) {
            const VertexHandle to = m_.to_vertex_handle(h);
            Quadric sum = quadric_[number(v)];
            sum += quadric_[number(to)];
            ways_.push_back({std::max(sum(m_.point(to)), 0.0), h});  // below 0 due to rounding
        }
        std::sort(ways_.begin(), ways_.end(), [](const Step& a, const Step& b) {
            return a.error != b.error ? a.error < b.error : a.way < b.way;
        });
        const auto found = std::find_if(ways_.begin(), ways_.end(),
                                        [&](const Step& s) { return !checked || may_go(s.way); });
        return found == ways_.end() ? Step{} : *found;
    }

    void enqueue(VertexHandle v) {
        const std::uint32_t turn = ++turn_[number(v)];
        if (m_.status(v).locked() || (m_.is_boundary(v) && !on_straight_boundary(v))) return;
        const Step step = best(v, false);
        if (step.way.is_valid()) queue_.push({step.error, number(v), turn});
    }

    /// Returns the number of removed faces.
    std::size_t take(HalfedgeHandle way) {
        const VertexHandle from = m_.from_vertex_handle(way), to = m_.to_vertex_handle(way);
        const std::size_t faces = m_.is_boundary(m_.edge_handle(way)) ? 1 : 2;
        around_.clear();
        for (const auto v : m_.vv_range(from)) around_.push_back(v);
        quadric_[number(to)] += quadric_[number(from)];
        m_.collapse(way);
        ++turn_[number(from)];
        for (const VertexHandle v : around_) enqueue(v);
        return faces;
    }

    bool may_go(HalfedgeHandle way) {
        const VertexHandle from = m_.from_vertex_handle(way), to = m_.to_vertex_handle(way);
        if (m_.is_boundary(from) && !m_.is_boundary(m_.edge_handle(way))) return false;
        if (m_.valence(from) < 3 || m_.valence(from) + m_.valence(to) > most_around + 4) return false;
        const Vec3d there = m_.point(to);
        for (const auto h : m_.voh_range(from))
            if (!m_.is_boundary(h) && h != way && spoils(h, to, there)) return false;
        return m_.is_collapse_ok(way) && !is_tetrahedron(way);
    }
    /// Whether v is on a straight line between its two neighbours on the boundary.
    bool on_straight_boundary(VertexHandle v) {
        const auto out = m_.halfedge_handle(v);  // at a boundary vertex it runs along the boundary
        const Vec3d a = m_.point(v) - m_.point(m_.from_vertex_handle(m_.prev_halfedge_handle(out)));
        const Vec3d b = m_.point(m_.to_vertex_handle(out)) - m_.point(v);
        return (a | b) > 0 && (a % b).norm() <= straight_boundary * a.norm() * b.norm();
    }
    /// Whether the face of a half-edge flips or becomes a needle once the vertex at its start moves to
    /// `there`.
    bool spoils(HalfedgeHandle h, VertexHandle to, const Vec3d& there) {
        const VertexHandle second = m_.to_vertex_handle(h),
                           third = m_.to_vertex_handle(m_.next_halfedge_handle(h));
        if (second == to || third == to) return false;  // the face is removed
        const Vec3d a = m_.point(second), b = m_.point(third), here = m_.point(m_.from_vertex_handle(h));
        const Vec3d before = (a - here) % (b - here), after = (a - there) % (b - there);
        const double longest = std::max({(a - there).sqrnorm(), (b - there).sqrnorm(), (b - a).sqrnorm()});
        if (after.norm() < least_height * longest && after.norm() < before.norm()) return true;
        return (before | after) <= least_turn * before.norm() * after.norm();
    }
    /// Whether the collapse would leave only two coincident faces of a tetrahedron.
    bool is_tetrahedron(HalfedgeHandle way) {
        const HalfedgeHandle back = m_.opposite_halfedge_handle(way);
        if (m_.is_boundary(way) || m_.is_boundary(back)) return false;
        const VertexHandle left = m_.to_vertex_handle(m_.next_halfedge_handle(way));
        const VertexHandle right = m_.to_vertex_handle(m_.next_halfedge_handle(back));
        return m_.valence(left) == 3 && m_.valence(right) == 3 && m_.find_halfedge(left, right).is_valid();
    }

    HalfEdges& m_;
    std::vector<Quadric> quadric_;
    std::vector<std::uint32_t> turn_;  // increased when a vertex's neighbourhood changes
    std::priority_queue<Waiting> queue_;
    std::vector<Step> ways_;  // reused between calls
    std::vector<VertexHandle> around_;
};

void request_status(HalfEdges& mesh) {
    mesh.request_vertex_status();
    mesh.request_halfedge_status();
    mesh.request_edge_status();
    mesh.request_face_status();
}

/// Locks the half-edge vertices that represent the same vertex of the mesh, because the mesh would tear
/// there, and those with many faces.
void lock(const Fans& fans, HalfEdges& mesh) {
    for (const auto v : mesh.vertices()) {
        const std::uint32_t position = fans.position[static_cast<std::size_t>(v.idx())];
        if (fans.is_split[position] != 0 || mesh.valence(v) > most_around) mesh.status(v).set_locked(true);
    }
}

/// The remaining faces, on their original vertices of `mesh`.
Mesh what_is_left(const Mesh& mesh, const Fans& fans, const HalfEdges& half_edges) {
    Mesh out;
    out.first_corner.push_back(0);
    std::vector<std::uint32_t> number(mesh.positions.size(), no_index);
    for (const auto f : half_edges.faces()) {
        if (half_edges.status(f).deleted()) continue;
        for (const auto v : half_edges.fv_range(f)) {
            const std::uint32_t from = fans.position[static_cast<std::size_t>(v.idx())];
            if (number[from] == no_index) {
                number[from] = static_cast<std::uint32_t>(out.positions.size());
                out.positions.push_back(mesh.positions[from]);
                if (!mesh.colors.empty()) out.colors.push_back(mesh.colors[from]);
            }
            out.corner_position.push_back(number[from]);
        }
        out.first_corner.push_back(static_cast<std::uint32_t>(out.corner_position.size()));
    }
    return out;
}

/// Precondition: the mesh has more triangles than `triangles`, which is 1 or more.
Mesh decimated(const Mesh& mesh, std::size_t triangles) {
    Mesh cut = with_vertices_of(mesh);
    for (const Triangle& triangle : mesh.triangles) {
        std::array<std::uint32_t, 3> vertices{};
        for (std::size_t i = 0; i < 3; ++i) vertices[i] = mesh.corner_position[triangle.corner[i]];
        add_polygon(cut, vertices);
    }
    Fans fans = fans_of(cut);
    // Positions are centred at the origin and scaled to within 1, so that no error is too large or too small
    // for a float.
    const glm::dvec3 middle = (glm::dvec3(mesh.bounds.min) + glm::dvec3(mesh.bounds.max)) / 2.0;
    const glm::dvec3 half = glm::dvec3(mesh.bounds.max) - middle;
    const double size = std::max({half.x, half.y, half.z});
    HalfEdges half_edges;
    request_status(half_edges);
    add_faces(
        cut, fans,
        [&](std::uint32_t v) {
            const glm::dvec3 p = (glm::dvec3(cut.positions[v]) - middle) / size;
            return Vec3d(p.x, p.y, p.z);
        },
        half_edges);
    lock(fans, half_edges);
    Collapses(half_edges).run(triangles);
    Mesh out = what_is_left(cut, fans, half_edges);
    out.warnings = mesh.warnings;
    if (out.face_count() > triangles)
        out.warnings.push_back(
            fmt::format("{} triangles are left, not {}: boundaries and edges of three or more faces keep "
                        "their shape, vertices with more than {} faces around them stay, and "
                        "no face turns over or becomes a needle",
                        out.face_count(), triangles, most_around));
    return out;
}

/// The number of faces after `steps` steps: the first step yields one face per corner of a polygon (4 per
/// triangle if all are triangles), each additional step 4 per face.
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
                   fmt::format("at most {} to change the resolution", max_faces_around)};
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
                           fmt::format("subdivided {} times, the mesh has {} faces", wanted.subdivide, faces),
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
