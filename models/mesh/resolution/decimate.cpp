// Decimation: M. Garland and P. Heckbert, "Surface simplification using quadric error metrics", 1997.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <queue>

#include "models/mesh/resolution/half_edges.h"
#include "models/mesh/resolution/resolution.h"
#include "models/progress.h"

// This header requires OpenMesh's vectors.
#include <OpenMesh/Core/Geometry/QuadricT.hh>

namespace glint {
namespace {

using HalfEdges = TriangleHalfEdges;
using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec3d;
using OpenMesh::VertexHandle;
using Quadric = OpenMesh::Geometry::QuadricT<double>;

// Vertices with more faces around them are not removed: each change around a vertex examines it again.
constexpr unsigned most_around = 48;
// The sine of the turn below which a boundary counts as straight at a vertex.
constexpr double straight_boundary = 1e-6;
// The cosine of the largest turn of a face in one step, 78 degrees, so that a flat area cannot fold over.
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
            ways_.push_back({std::max(sum(m_.point(to)), 0.0), h});  // below 0 by rounding
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

}  // namespace

Mesh decimated(const Mesh& mesh, std::size_t triangles) {
    const Mesh cut = triangles_of(mesh);
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
            fmt::format("{} triangles are left, not {}: boundaries and places where edges of three faces and "
                        "more meet keep their shape, vertices with more than {} faces around them stay, and "
                        "no face turns over or becomes a needle",
                        out.face_count(), triangles, most_around));
    return out;
}

}  // namespace glint
