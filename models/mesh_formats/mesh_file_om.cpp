// OpenMesh's own .om. Its reader trusts every count and size, and its mesh drops or moves faces that are not
// manifold, so both are read here. Source: OpenMesh documentation, "The OM file format";
// OpenMesh/Core/IO/OMFormat.hh.
#include <fmt/core.h>

#include <OpenMesh/Core/IO/OMFormat.hh>
#include <array>
#include <cmath>
#include <optional>

#include "models/memory_limit.h"
#include "models/mesh_formats/mesh_reader.h"

namespace glint {
namespace {

using OpenMesh::IO::OMFormat::Chunk;

constexpr std::size_t header_size = 16;
constexpr unsigned version_2 = 2 << 5, newest = 2 << 5 | 2;  // major and minor, 3 and 5 bits

/// The fields of a chunk's header, 16 bits.
struct ChunkHeader {
    unsigned value;
    [[nodiscard]] unsigned bits(int offset, int size) const { return value >> offset & ((1u << size) - 1); }
    [[nodiscard]] bool named() const { return bits(Chunk::OFF_NAME, Chunk::SIZE_NAME) != 0; }
    [[nodiscard]] unsigned entity() const { return bits(Chunk::OFF_ENTITY, Chunk::SIZE_ENTITY); }
    [[nodiscard]] unsigned type() const { return bits(Chunk::OFF_TYPE, Chunk::SIZE_TYPE); }
    [[nodiscard]] bool is_float() const { return bits(Chunk::OFF_FLOAT, Chunk::SIZE_FLOAT) != 0; }
    [[nodiscard]] unsigned dimensions() const { return bits(Chunk::OFF_DIM, Chunk::SIZE_DIM) + 1; }
    [[nodiscard]] unsigned size_code() const { return bits(Chunk::OFF_BITS, Chunk::SIZE_BITS); }
    [[nodiscard]] std::size_t integer_bytes() const { return std::size_t{1} << size_code(); }
    [[nodiscard]] std::size_t vector_bytes() const {
        return dimensions() * (is_float() ? std::size_t{4} << size_code() : integer_bytes());
    }
};

class OmReader {
  public:
    OmReader(std::string_view bytes, const std::string& file)
        : bytes_(bytes), file_(file), parsed_(bytes.size()) {
        if (bytes.substr(0, 2) != "OM" || bytes.size() < header_size)
            fail("this is not an OM file", "\"OM\" and its counts");
        kind_ = bytes[2];
        if (kind_ != 'T' && kind_ != 'Q' && kind_ != 'P')
            fail(fmt::format("{} is not a kind of mesh", quoted_word(bytes.substr(2, 1))), "T, Q or P");
        version_ = static_cast<unsigned char>(bytes[3]);
        if (version_ > newest) fail("the file is of a newer version", "2.2 at most");
        vertices_ = natural(4, 4);
        faces_ = natural(8, 4);
        edges_ = natural(12, 4);
        if (vertices_ > max_corners || faces_ > max_corners || edges_ > max_corners / 2)
            fail("a count is out of range", fmt::format("at most {}", max_corners));
    }

    Mesh read() {
        read_chunks();
        if (other_normals_) mesh_.warnings.emplace_back("vertex normals of an unusual type are ignored");
        if (other_colors_) mesh_.warnings.emplace_back("vertex colours of an unusual type are ignored");
        if (!positions_ && vertices_ > 0)
            fail("the file has no positions of its vertices", "a chunk of positions");
        if (positions_) mesh_.positions = vectors(*positions_, "a coordinate");
        if (normals_) mesh_.normals = vectors(*normals_, "a normal");
        if (normals_) mesh_.given_normals = GivenNormals::File;
        if (colors_) read_colors(*colors_);
        mesh_.first_corner.push_back(0);
        if (face_chunk_ && version_ < version_2) add_polygons(*face_chunk_);
        if (face_chunk_ && version_ >= version_2) add_loops(*face_chunk_);
        if (deleted_faces_) mesh_.warnings.emplace_back("faces that are marked as deleted are left out");
        return std::move(mesh_);
    }

  private:
    struct Data {
        ChunkHeader header;
        std::size_t at;  // the first byte behind the header
    };

    [[noreturn]] void fail(std::string what, std::string expected) const {
        throw Unreadable{{file_, "", std::move(what), std::move(expected), 0}};
    }
    [[noreturn]] void fail_in_face(const std::string& what, std::string expected) const {
        fail(fmt::format("face {}: {}", mesh_.face_count(), what), std::move(expected));
    }

    /// Reads an unsigned little-endian number of 1 to 8 bytes.
    [[nodiscard]] std::size_t natural(std::size_t at, std::size_t size) const {
        if (at + size > bytes_.size()) fail("the file ends early", "a chunk or the end mark");
        return little_endian(&bytes_[at], size);
    }
    /// Reads a signed little-endian number of 1 to 8 bytes.
    [[nodiscard]] std::int64_t integer(std::size_t at, std::size_t size) const {
        const std::size_t sign = std::size_t{1} << (8 * size - 1), value = natural(at, size);
        return static_cast<std::int64_t>(value ^ sign) - static_cast<std::int64_t>(sign);
    }

    /// Finds the chunks that make up the mesh, each there whole and once.
    void read_chunks() {
        std::size_t at = header_size;
        while (at < bytes_.size()) {
            parsed_.at(at);
            const ChunkHeader header{static_cast<unsigned>(natural(at, 2))};
            at += 2;
            if (header.entity() == Chunk::Entity_Sentinel) return;
            if (header.named() || header.type() == Chunk::Type_Custom) {  // writers put these last
                mesh_.warnings.emplace_back("custom properties are ignored");
                return;
            }
            const std::size_t size = data_size(header, at);
            if (size > bytes_.size() - at)
                fail("the file ends early", fmt::format("a chunk of {} bytes", size));
            keep({header, at});
            at += size;
        }
    }

    [[nodiscard]] std::size_t count(const ChunkHeader& header) const {
        const std::array<std::pair<unsigned, std::size_t>, 5> counts{{{Chunk::Entity_Vertex, vertices_},
                                                                      {Chunk::Entity_Face, faces_},
                                                                      {Chunk::Entity_Edge, edges_},
                                                                      {Chunk::Entity_Halfedge, 2 * edges_},
                                                                      {Chunk::Entity_Mesh, 1}}};
        for (const auto& [entity, count] : counts)
            if (entity == header.entity()) return count;
        fail(fmt::format("a chunk is of the unknown kind {}", header.entity()), "0, 1, 2, 4, 6 or 7");
    }

    /// Before version 2 OpenMesh called the bytes of a colour 4-byte floats.
    [[nodiscard]] bool is_old_color(const ChunkHeader& header) const {
        return version_ < version_2 && header.type() == Chunk::Type_Color && header.dimensions() == 3 &&
               header.is_float() && header.size_code() == Chunk::Float_32;
    }

    std::size_t data_size(const ChunkHeader& header, std::size_t at) {
        if (header.type() == Chunk::Type_Status) return 4 * count(header);
        if (header.type() != Chunk::Type_Topology)
            return count(header) * (is_old_color(header) ? 3 : header.vector_bytes());
        const std::size_t size = header.integer_bytes();
        if (size > 4) fail("indices have 8 bytes", "1, 2 or 4");
        if (header.entity() == Chunk::Entity_Halfedge) return 3 * size * count(header);  // next, vertex, face
        if (header.entity() != Chunk::Entity_Face || version_ >= version_2) return size * count(header);
        if (kind_ != 'P') return (kind_ == 'T' ? 3 : 4) * size * faces_;
        std::size_t total = 0;  // each face: 2 bytes of a count, then the vertices
        for (std::size_t f = 0; f < faces_; ++f) {
            parsed_.at(at + total);
            total += 2 + size * natural(at + total, 2);
        }
        return total;
    }

    void keep(const Data& chunk) {
        const auto once = [&](std::optional<Data>& as) {
            if (as) fail("a chunk comes twice", "one of each");
            as = chunk;
        };
        const ChunkHeader& header = chunk.header;
        if (header.type() == Chunk::Type_Topology) {
            if (header.entity() == Chunk::Entity_Halfedge) once(halfedge_chunk_);
            if (header.entity() == Chunk::Entity_Face) once(face_chunk_);
            return;
        }
        if (header.type() == Chunk::Type_Status && header.entity() == Chunk::Entity_Face) once(face_status_);
        if (header.entity() != Chunk::Entity_Vertex) return;
        const bool three = header.dimensions() == 3;
        const bool floats = header.is_float() && header.size_code() == Chunk::Float_32 && three;
        const bool bytes = !header.is_float() && header.integer_bytes() == 1 && three;
        if (header.type() == Chunk::Type_Pos) {
            if (!floats) fail("the positions are of an unusual type", "three 4-byte floats each");
            once(positions_);
        } else if (header.type() == Chunk::Type_Normal) {
            floats ? once(normals_) : void(other_normals_ = true);
        } else if (header.type() == Chunk::Type_Color) {
            bytes || is_old_color(header) ? once(colors_) : void(other_colors_ = true);
        }
    }

    /// One a vertex. `what`: as a message calls one of its numbers.
    std::vector<glm::vec3> vectors(const Data& chunk, const char* what) {
        std::vector<glm::vec3> read;
        make_room(mesh_, read, vertices_);
        read.resize(vertices_);
        for (std::size_t v = 0; v < vertices_; ++v) {
            parsed_.at(chunk.at + 12 * v);
            for (std::size_t i = 0; i < 3; ++i) {
                const float number = little_endian_float(&bytes_[chunk.at + 12 * v + 4 * i]);
                if (!(std::abs(number) <= static_cast<float>(max_number)))
                    fail(fmt::format("vertex {}: {} of {} is out of range", v, what, number),
                         "-1e30 to 1e30");
                read[v][static_cast<int>(i)] = number;
            }
        }
        return read;
    }

    void read_colors(const Data& chunk) {
        make_room(mesh_, mesh_.colors, vertices_);
        for (std::size_t at = chunk.at; at < chunk.at + 3 * vertices_; at += 3)
            mesh_.colors.push_back(glm::vec3(natural(at, 1), natural(at + 1, 1), natural(at + 2, 1)) / 255.f);
    }

    /// OpenMesh marks a face that is deleted, and leaves it in the file until its garbage is collected.
    bool is_deleted(std::size_t face) {
        if (!face_status_ || (natural(face_status_->at + 4 * face, 4) & OpenMesh::Attributes::DELETED) == 0)
            return false;
        deleted_faces_ = true;
        return true;
    }

    void add_corner(std::int64_t vertex) {
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices_)
            fail_in_face(fmt::format("vertex index {} is out of range", vertex),
                         numbers_of(vertices_, "vertices"));
        constexpr std::size_t corners_between_reports = 1 << 16;
        if (mesh_.corner_position.size() % corners_between_reports == 0)
            report_or_leave(LoadStage::Building, mesh_.face_count(), faces_);
        append(mesh_, mesh_.corner_position, static_cast<std::uint32_t>(vertex));
    }

    /// Adds the faces of a file before version 2, which lists the vertices of each face.
    void add_polygons(const Data& chunk) {
        const std::size_t size = chunk.header.integer_bytes();
        std::size_t at = chunk.at;
        for (std::size_t f = 0; f < faces_; ++f) {
            std::size_t corners = kind_ == 'T' ? 3 : 4;
            if (kind_ == 'P') {
                corners = natural(at, 2);
                at += 2;
            }
            if (is_deleted(f)) {
                at += corners * size;
                continue;
            }
            for (; corners > 0; --corners, at += size)
                add_corner(static_cast<std::int64_t>(natural(at, size)));
            close_face(mesh_, file_);
        }
    }

    /// Adds the faces of a file from version 2 on, which lists one half-edge of each face; the next ones lead
    /// round it.
    void add_loops(const Data& chunk) {
        const MemoryShare share(memory_need(MemoryUse::Meshes, halfedge_chunk_ ? 2 * edges_ : 0));
        std::vector<char> walked(halfedge_chunk_ ? 2 * edges_ : 0, 0);  // each belongs to one face only
        const std::size_t size = chunk.header.integer_bytes();
        for (std::size_t f = 0; f < faces_; ++f) {
            if (is_deleted(f)) continue;
            const std::int64_t first = integer(chunk.at + f * size, size);
            std::int64_t half = first;
            do {
                if (half < 0 || static_cast<std::size_t>(half) >= walked.size())
                    fail_in_face(fmt::format("half-edge index {} is out of range", half),
                                 numbers_of(walked.size(), "half-edges"));
                if (walked[static_cast<std::size_t>(half)]++ != 0)
                    fail_in_face("its half-edges do not form a loop", "each once");
                add_corner(of_halfedge(half ^ 1, 1));  // where it starts
                half = of_halfedge(half, 0);
            } while (half != first);
            close_face(mesh_, file_);
        }
    }

    /// Index `which` of a half-edge: 0 is the index of the next half-edge, 1 that of the vertex to which it
    /// leads. Half-edges 2e and 2e + 1 are edge e. Preconditions: there is a chunk of them, and `half` is
    /// below 2 edges_.
    [[nodiscard]] std::int64_t of_halfedge(std::int64_t half, std::size_t which) const {
        const std::size_t size = halfedge_chunk_->header.integer_bytes();
        return integer(halfedge_chunk_->at + size * (3 * static_cast<std::size_t>(half) + which), size);
    }

    std::string_view bytes_;
    const std::string& file_;
    ParsedBytes parsed_;
    Mesh mesh_;
    char kind_ = 'P';
    unsigned version_ = 0;
    std::size_t vertices_ = 0, faces_ = 0, edges_ = 0;
    std::optional<Data> positions_, normals_, colors_, face_chunk_, halfedge_chunk_, face_status_;
    bool other_normals_ = false, other_colors_ = false, deleted_faces_ = false;
};

}  // namespace

Mesh read_om(std::string_view bytes, const std::string& file) { return OmReader(bytes, file).read(); }

}  // namespace glint
