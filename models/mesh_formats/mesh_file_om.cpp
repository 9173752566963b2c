// OpenMesh's own .om, read by OpenMesh into lists of ours: its own mesh would drop or move faces that are not
// manifold.
#include <fmt/core.h>

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OMReader.hh>
#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <cmath>
#include <mutex>
#include <sstream>

#include "models/mesh_formats/mesh_reader.h"
#include "models/mesh_formats/om_chunks.h"

#if defined(__SANITIZE_ADDRESS__)
// OpenMesh keeps 16 bytes from its loading to the end of the program; the leak check need not tell of them.
extern "C" const char*
__lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier): the sanitizer's
extern "C" const char* __lsan_default_suppressions() { return "leak:libOpenMeshCore"; }
#endif

namespace glint {
namespace {

struct OmHalfedge {
    int to_vertex = -1, next = -1;
};

/// What the reader hands over. Everything arrives unchecked: indices may be anything.
class OmImporter final : public OpenMesh::IO::BaseImporter {
  public:
    using Face = OpenMesh::FaceHandle;
    using Vertex = OpenMesh::VertexHandle;
    using Edge = OpenMesh::EdgeHandle;
    using Half = OpenMesh::HalfedgeHandle;
    using Status = OpenMesh::Attributes::StatusInfo;
    using Vec2f = OpenMesh::Vec2f;
    using Vec3f = OpenMesh::Vec3f;
    using Vec3d = OpenMesh::Vec3d;
    using Vec4f = OpenMesh::Vec4f;
    using Vec3uc = OpenMesh::Vec3uc;
    using Vec4uc = OpenMesh::Vec4uc;

    /// `stream` is what the reader reads: its place tells the progress. Throws LoadCancelled out of the
    /// reader.
    OmImporter(std::istream& stream, std::size_t bytes) : stream_(stream), parsed_(bytes) {}

    std::vector<glm::vec3> positions, normals, colors;
    std::vector<std::vector<int>> polygons;  // versions before 2: the vertices of each face
    std::vector<OmHalfedge> halfedges;       // version 2: half-edges 2e and 2e + 1 are edge e
    std::vector<int> face_halfedges;         // version 2: one half-edge of each face

    Vertex add_vertex(const Vec3f& p) override {
        report();
        positions.emplace_back(p[0], p[1], p[2]);
        return Vertex(static_cast<int>(positions.size() - 1));
    }
    Vertex add_vertex() override { return add_vertex(Vec3f(0, 0, 0)); }
    Half add_edge(Vertex from, Vertex to) override {
        report();
        halfedges.push_back({to.idx(), -1});
        halfedges.push_back({from.idx(), -1});
        return Half(static_cast<int>(halfedges.size() - 2));
    }
    Face add_face(const VHandles& vertices) override {
        report();
        polygons.emplace_back();
        for (const Vertex v : vertices) polygons.back().push_back(v.idx());
        return Face(static_cast<int>(polygons.size() - 1));
    }
    Face add_face(Half half) override {
        report();
        face_halfedges.push_back(half.idx());
        return Face(static_cast<int>(face_halfedges.size() - 1));
    }
    void set_next(Half half, Half next) override { at(half).next = next.idx(); }
    void set_normal(Vertex /*v*/, const Vec3f& n) override {
        report();
        normals.emplace_back(n[0], n[1], n[2]);
    }
    void set_normal(Vertex /*v*/, const Vec3d& n) override { normals.emplace_back(n[0], n[1], n[2]); }
    void set_color(Vertex /*v*/, const Vec3uc& c) override {
        report();
        colors.push_back(glm::vec3(c[0], c[1], c[2]) / 255.f);
    }
    std::size_t n_vertices() const override { return positions.size(); }
    std::size_t n_faces() const override { return polygons.size() + face_halfedges.size(); }
    std::size_t n_edges() const override { return halfedges.size() / 2; }
    OpenMesh::BaseKernel* kernel() override { return &scratch_; }

    // The rest is not asked for: the reader is given no chunk that would bring it.
    void set_point(Vertex, const Vec3f&) override {}
    void set_halfedge(Vertex, Half) override {}
    void set_face(Half, Face) override {}
    void set_color(Vertex, const Vec4uc&) override {}
    void set_color(Vertex, const Vec3f&) override {}
    void set_color(Vertex, const Vec4f&) override {}
    void set_texcoord(Vertex, const Vec2f&) override {}
    void set_texcoord(Vertex, const Vec3f&) override {}
    void set_status(Vertex, const Status&) override {}
    void set_texcoord(Half, const Vec2f&) override {}
    void set_texcoord(Half, const Vec3f&) override {}
    void set_status(Half, const Status&) override {}
    void set_color(Edge, const Vec3uc&) override {}
    void set_color(Edge, const Vec4uc&) override {}
    void set_color(Edge, const Vec3f&) override {}
    void set_color(Edge, const Vec4f&) override {}
    void set_status(Edge, const Status&) override {}
    void set_normal(Face, const Vec3f&) override {}
    void set_normal(Face, const Vec3d&) override {}
    void set_color(Face, const Vec3uc&) override {}
    void set_color(Face, const Vec4uc&) override {}
    void set_color(Face, const Vec3f&) override {}
    void set_color(Face, const Vec4f&) override {}
    void set_status(Face, const Status&) override {}
    void set_face_texindex(Face, int) override {}
    void add_face_texcoords(Face, Vertex, const std::vector<Vec2f>&) override {}
    void add_face_texcoords(Face, Vertex, const std::vector<Vec3f>&) override {}
    void request_face_texcoords2D() override {}
    void add_texture_information(int, std::string) override {}

  private:
    void report() {
        constexpr std::size_t calls_between_reports = 4096;
        if (++calls_ % calls_between_reports == 0) parsed_.at(static_cast<std::size_t>(stream_.tellg()));
    }
    OmHalfedge& at(Half half) { return halfedges.at(static_cast<std::size_t>(half.idx())); }

    std::istream& stream_;
    ParsedBytes parsed_;
    std::size_t calls_ = 0;
    OpenMesh::PolyConnectivity scratch_;  // the reader insists on a kernel; it stays empty
};

/// Turns what the reader handed over into polygons, checking every index.
class OmPolygons {
  public:
    OmPolygons(const OmImporter& from, Mesh& mesh, const std::string& file)
        : from_(from), mesh_(mesh), file_(file), walked_(from.halfedges.size(), 0) {}

    void add_all() {
        for (const auto& polygon : from_.polygons) {
            for (const int v : polygon) add_corner(v);
            close_face(mesh_, file_);
        }
        for (const int halfedge : from_.face_halfedges) {
            add_loop(halfedge);
            close_face(mesh_, file_);
        }
    }

  private:
    void add_corner(int vertex) {
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= from_.positions.size())
            fail(fmt::format("vertex index {} is out of range", vertex),
                 from_.positions.empty() ? "vertices" : fmt::format("0 to {}", from_.positions.size() - 1));
        constexpr std::size_t corners_between_reports = 1 << 16;
        if (mesh_.corner_position.size() % corners_between_reports == 0)
            report_or_leave(LoadStage::Building, mesh_.face_count(), from_.n_faces());
        mesh_.corner_position.push_back(static_cast<std::uint32_t>(vertex));
    }

    /// Round the face along its half-edges, each of which belongs to one loop only.
    void add_loop(int first) {
        int half = first;
        do {
            if (half < 0 || static_cast<std::size_t>(half) >= from_.halfedges.size())
                fail(fmt::format("half-edge index {} is out of range", half),
                     from_.halfedges.empty() ? "half-edges"
                                             : fmt::format("0 to {}", from_.halfedges.size() - 1));
            if (walked_[static_cast<std::size_t>(half)]++ != 0)
                fail("its half-edges form no loop", "each once");
            add_corner(from_.halfedges[static_cast<std::size_t>(half ^ 1)].to_vertex);  // where it starts
            half = from_.halfedges[static_cast<std::size_t>(half)].next;
        } while (half != first);
    }

    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        throw Unreadable{{file_, "", fmt::format("face {}: {}", mesh_.face_count(), what), expected, 0}};
    }

    const OmImporter& from_;
    Mesh& mesh_;
    const std::string& file_;
    std::vector<char> walked_;
};

void check_finite(const std::vector<glm::vec3>& vectors, const char* what, const std::string& file) {
    for (std::size_t v = 0; v < vectors.size(); ++v)
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(vectors[v][i]) <= static_cast<float>(max_number)))
                throw Unreadable{{file, "",
                                  fmt::format("vertex {}: {} of {} is out of range", v, what, vectors[v][i]),
                                  "-1e30 to 1e30", 0}};
}

}  // namespace

Mesh read_om(std::string_view bytes, const std::string& file) {
    Mesh mesh;
    mesh.first_corner.push_back(0);
    std::istringstream stream(sound_om_chunks(bytes, file, mesh.warnings));
    OmImporter importer(stream, bytes.size());
    OpenMesh::IO::Options options = OpenMesh::IO::Options::Binary;
    options += OpenMesh::IO::Options::VertexNormal;
    options += OpenMesh::IO::Options::VertexColor;
    {
        static std::mutex one_at_a_time;  // the reader is one object and keeps its state in it
        const std::lock_guard lock(one_at_a_time);
        if (!OpenMesh::IO::OMReader().read(stream, importer, options))
            throw Unreadable{{file, "", "OpenMesh cannot read this file", "an OM file that it wrote", 0}};
    }
    check_finite(importer.positions, "a coordinate", file);
    check_finite(importer.normals, "a normal", file);
    OmPolygons(importer, mesh, file).add_all();
    if (importer.normals.size() == importer.positions.size()) {
        mesh.normals = std::move(importer.normals);
        mesh.given_normals = GivenNormals::File;
    }
    if (importer.colors.size() == importer.positions.size()) mesh.colors = std::move(importer.colors);
    mesh.positions = std::move(importer.positions);
    return mesh;
}

}  // namespace glint
