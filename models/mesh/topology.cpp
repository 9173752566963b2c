#include "models/mesh/topology.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>

namespace glint {
namespace {

using OpenMesh::PolyConnectivity;
using VertexHandle = OpenMesh::VertexHandle;

// OpenMesh visits every edge of a vertex when it adds a face there: a fan of a million triangles would take
// 10^12 steps. A vertex is split after this many faces.
constexpr std::uint32_t max_faces_at_vertex = 256;

/// A side of a polygon: the two vertices, the smaller first, and its polygon.
struct Side {
    std::array<std::uint32_t, 2> edge;
    EdgeUse use;
};

std::array<std::uint32_t, 2> sorted(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::array{a, b} : std::array{b, a};
}

/// OpenMesh prints every face that it rejects; we store those separately. It is silenced once, so that
/// threads do not race.
void silence_openmesh() {
    static const bool done = (::omerr().disable(), true);
    static_cast<void>(done);
}

/// Fills OpenMesh connectivity with the polygons of a mesh and reads the edges back.
class Builder {
  public:
    explicit Builder(const Mesh& mesh) : mesh_(mesh), split_(mesh.positions.size(), 0) {
        silence_openmesh();
        // Reserves for the worst case: no two sides share an edge, and each corner has its own vertex. A
        // growing vector briefly exists twice, while reserved but unwritten pages use no memory.
        const std::size_t sides = mesh.corner_position.size(), vertices = mesh.positions.size() + sides;
        connectivity_.reserve(vertices, sides, mesh.face_count());
        original_.reserve(vertices);
        face_.reserve(mesh.face_count());
        apart_.reserve(sides);
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) new_vertex(v);
        current_.resize(mesh.positions.size());
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
            current_[v] = VertexHandle(static_cast<int>(v));
        faces_at_.resize(mesh.positions.size(), 0);
    }

    Topology build() {
        for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) add_polygon(f);
        Topology t;
        read_edges(t);
        read_split_edges(t);
        t.first_use.push_back(static_cast<std::uint32_t>(t.uses.size()));
        return t;
    }

  private:
    VertexHandle new_vertex(std::uint32_t v) {
        original_.push_back(v);
        return connectivity_.add_vertex();
    }

    /// The polygon's corners without those that repeat the vertex of the corner before them.
    void collect(std::uint32_t f) {
        corners_.clear();
        for (std::uint32_t c = mesh_.first_corner[f]; c < mesh_.first_corner[f + 1]; ++c)
            if (mesh_.place_of(c) != mesh_.place_of(next_corner(mesh_, f, c))) corners_.push_back(c);
    }

    /// Whether a half-edge structure cannot represent the face: it contains a vertex twice, or has fewer than
    /// three.
    bool cannot_be_held() {
        if (corners_.size() < 3) return true;
        if (corners_.size() == 3) {  // neighbours differ, so all three do
            return false;
        }
        vertices_.clear();
        for (const std::uint32_t c : corners_) vertices_.push_back(mesh_.place_of(c));
        std::sort(vertices_.begin(), vertices_.end());
        return std::adjacent_find(vertices_.begin(), vertices_.end()) != vertices_.end();
    }

    void add_polygon(std::uint32_t f) {
        collect(f);
        if (cannot_be_held()) {
            for (const std::uint32_t c : corners_) {
                const std::uint32_t a = mesh_.place_of(c);
                const std::uint32_t b = mesh_.place_of(next_corner(mesh_, f, c));
                split_[a] = split_[b] = 1;
                apart_.push_back({sorted(a, b), {f, c}});
            }
            return;
        }
        handles_.clear();
        for (const std::uint32_t c : corners_) handles_.push_back(handle_for(mesh_.place_of(c)));
        if (!connectivity_.add_face(handles_.data(), handles_.size()).is_valid()) {
            handles_.clear();
            for (const std::uint32_t c : corners_) {
                split_[mesh_.place_of(c)] = 1;
                handles_.push_back(new_vertex(mesh_.place_of(c)));
            }
            connectivity_.add_face(handles_.data(), handles_.size());
        }
        face_.push_back(f);
    }

    VertexHandle handle_for(std::uint32_t v) {
        if (++faces_at_[v] > max_faces_at_vertex) {
            faces_at_[v] = 1;
            split_[v] = 1;
            current_[v] = new_vertex(v);
        }
        return current_[v];
    }

    /// The corner of our polygon at which each half-edge starts; no_index on the outer side of a boundary.
    std::vector<std::uint32_t> corners_of_halfedges() {
        std::vector<std::uint32_t> corner(connectivity_.n_halfedges(), no_index);
        for (std::uint32_t i = 0; i < face_.size(); ++i) {
            collect(face_[i]);
            auto h = connectivity_.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(i)));
            const auto from = [&] { return original_[vertex_index(connectivity_.from_vertex_handle(h))]; };
            while (from() != mesh_.place_of(corners_[0])) h = connectivity_.next_halfedge_handle(h);
            for (const std::uint32_t c : corners_) {
                corner[static_cast<std::size_t>(h.idx())] = c;
                h = connectivity_.next_halfedge_handle(h);
            }
        }
        return corner;
    }

    static std::size_t vertex_index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

    void read_edges(Topology& t) {
        const std::vector<std::uint32_t> corner = corners_of_halfedges();
        const std::size_t sides = mesh_.corner_position.size();
        t.edges.reserve(sides);
        t.first_use.reserve(sides + 1);
        t.uses.reserve(sides);
        for (std::size_t e = 0; e < connectivity_.n_edges(); ++e) {
            const OpenMesh::HalfedgeHandle h(static_cast<int>(2 * e));
            const std::uint32_t a = original_[vertex_index(connectivity_.from_vertex_handle(h))];
            const std::uint32_t b = original_[vertex_index(connectivity_.to_vertex_handle(h))];
            // Unless one of the vertices is split, no other edge can join the same two.
            const bool whole = split_[a] == 0 && split_[b] == 0;
            if (whole) {
                t.edges.push_back(sorted(a, b));
                t.first_use.push_back(static_cast<std::uint32_t>(t.uses.size()));
            }
            for (std::size_t side = 2 * e; side < 2 * e + 2; ++side) {
                if (corner[side] == no_index) continue;
                const OpenMesh::HalfedgeHandle half(static_cast<int>(side));
                const auto f = static_cast<std::size_t>(connectivity_.face_handle(half).idx());
                const EdgeUse use{face_[f], corner[side]};
                if (whole)
                    t.uses.push_back(use);
                else
                    apart_.push_back({sorted(a, b), use});
            }
        }
    }

    /// Joins the edges that OpenMesh stores in several pieces.
    void read_split_edges(Topology& t) {
        std::sort(apart_.begin(), apart_.end(), [](const Side& x, const Side& y) {
            return x.edge != y.edge ? x.edge < y.edge : x.use.corner < y.use.corner;
        });
        for (std::size_t i = 0; i < apart_.size(); ++i) {
            if (i == 0 || apart_[i].edge != apart_[i - 1].edge) {
                t.edges.push_back(apart_[i].edge);
                t.first_use.push_back(static_cast<std::uint32_t>(t.uses.size()));
            }
            t.uses.push_back(apart_[i].use);
        }
    }

    const Mesh& mesh_;
    PolyConnectivity connectivity_;
    std::vector<std::uint32_t> original_;  // vertex of the mesh, by vertex of OpenMesh
    std::vector<std::uint32_t> face_;      // face of the mesh, by face of OpenMesh
    std::vector<VertexHandle> current_;    // by vertex of the mesh: the vertex for its next face
    std::vector<std::uint32_t> faces_at_;  // by vertex of the mesh: faces at current_
    std::vector<char> split_;              // by vertex of the mesh: has several OpenMesh vertices
    std::vector<Side> apart_;
    std::vector<std::uint32_t> corners_, vertices_;
    std::vector<VertexHandle> handles_;
};

}  // namespace

Topology make_topology(const Mesh& mesh) { return Builder(mesh).build(); }

EdgeKind edge_kind(const Mesh& mesh, const Topology& topology, std::size_t edge) {
    const auto uses = topology.uses_of(edge);
    if (uses.size() == 1) return EdgeKind::Boundary;
    if (uses.size() > 2) return EdgeKind::NonManifold;
    const bool same = mesh.place_of(uses[0].corner) == mesh.place_of(uses[1].corner);
    return same ? EdgeKind::Inconsistent : EdgeKind::Manifold;
}

}  // namespace glint
