#include "models/mesh_formats/om_chunks.h"

#include <fmt/core.h>

#include <OpenMesh/Core/IO/OMFormat.hh>

#include "models/mesh_formats/mesh_reader.h"

namespace glint {
namespace {

using OpenMesh::IO::OMFormat::Chunk;

constexpr std::size_t header_size = 16;

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

/// Walks the chunks, checks that each is there whole, and copies those that make up the mesh.
class ChunkFilter {
  public:
    ChunkFilter(std::string_view bytes, const std::string& file)
        : bytes_(bytes), file_(file), parsed_(bytes.size()) {
        if (bytes.substr(0, 2) != "OM" || bytes.size() < header_size)
            fail("this is no OM file", "\"OM\" and its counts");
        kind_ = bytes[2];
        if (kind_ != 'T' && kind_ != 'Q' && kind_ != 'P')
            fail(fmt::format("{} is no kind of mesh", quoted_word(bytes.substr(2, 1))), "T, Q or P");
        version_ = static_cast<unsigned char>(bytes[3]);
        if (version_ > newest) fail("the file is of a newer version", "2.2 at most");
        vertices_ = little_endian(4, 4);
        faces_ = little_endian(8, 4);
        edges_ = little_endian(12, 4);
        if (vertices_ > most_corners || faces_ > most_corners || edges_ > most_corners / 2)
            fail("a count is out of range", fmt::format("at most {}", most_corners));
    }

    /// A file of the same mesh that is sound in its structure (indices may still be wrong).
    std::string sound(Warnings& warnings) {
        std::string out(bytes_.substr(0, header_size));
        at_ = header_size;
        while (at_ < bytes_.size()) {
            parsed_.at(at_);
            const std::size_t start = at_;
            const ChunkHeader header{static_cast<unsigned>(little_endian(at_, 2))};
            at_ += 2;
            if (header.entity() == Chunk::Entity_Sentinel) break;
            if (header.named() || header.type() == Chunk::Type_Custom) {  // writers put these last
                warnings.emplace_back("custom properties are ignored");
                break;
            }
            const std::size_t size = data_size(header);
            if (size > bytes_.size() - at_)
                fail("the file ends early", fmt::format("a chunk of {} bytes", size));
            at_ += size;
            if (wanted(header)) out += bytes_.substr(start, at_ - start);
        }
        if (other_normals_) warnings.emplace_back("vertex normals of an unusual type are ignored");
        if (other_colors_) warnings.emplace_back("vertex colours of an unusual type are ignored");
        if (!has_places_ && vertices_ > 0)
            fail("the file has no places of its vertices", "a chunk of positions");
        return out.append({static_cast<char>(Chunk::Entity_Sentinel << Chunk::OFF_ENTITY), 0});
    }

  private:
    static constexpr unsigned version_2 = 2 << 5, newest = 2 << 5 | 2;  // major and minor, 3 and 5 bits

    [[noreturn]] void fail(std::string what, std::string expected) const {
        throw Unreadable{{file_, "", std::move(what), std::move(expected), 0}};
    }

    [[nodiscard]] std::size_t little_endian(std::size_t at, std::size_t size) const {
        if (at + size > bytes_.size()) fail("the file ends early", "a chunk or the end mark");
        std::size_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value |= std::size_t{static_cast<unsigned char>(bytes_[at + i])} << (8 * i);
        return value;
    }

    [[nodiscard]] std::size_t count(const ChunkHeader& header) const {
        switch (header.entity()) {
        case Chunk::Entity_Vertex:
            return vertices_;
        case Chunk::Entity_Face:
            return faces_;
        case Chunk::Entity_Edge:
            return edges_;
        case Chunk::Entity_Halfedge:
            return 2 * edges_;
        case Chunk::Entity_Mesh:
            return 1;
        default:
            fail(fmt::format("a chunk is of the unknown kind {}", header.entity()), "0, 1, 2, 4, 6 or 7");
        }
    }

    std::size_t data_size(const ChunkHeader& header) {
        if (header.type() == Chunk::Type_Status) return 4 * count(header);
        if (header.type() != Chunk::Type_Topology) return count(header) * header.vector_bytes();
        const std::size_t size = header.integer_bytes();
        if (size > 4) fail("indices have 8 bytes", "1, 2 or 4");
        if (header.entity() == Chunk::Entity_Halfedge) return 3 * size * count(header);  // next, vertex, face
        if (header.entity() != Chunk::Entity_Face || version_ >= version_2) return size * count(header);
        if (kind_ != 'P') return (kind_ == 'T' ? 3 : 4) * size * faces_;
        std::size_t total = 0;  // each face: 2 bytes of a count, then the vertices
        for (std::size_t f = 0; f < faces_; ++f) {
            parsed_.at(at_ + total);
            total += 2 + size * little_endian(at_ + total, 2);
        }
        return total;
    }

    bool wanted(const ChunkHeader& header) {
        const auto once = [this](bool& seen) {
            if (seen) fail("a chunk comes twice", "one of each");
            return seen = true;
        };
        if (header.type() == Chunk::Type_Topology) {
            if (header.entity() == Chunk::Entity_Halfedge) return once(has_halfedges_);
            return header.entity() == Chunk::Entity_Face && once(has_faces_);
        }
        if (header.entity() != Chunk::Entity_Vertex) return false;
        const bool floats =
            header.is_float() && header.size_code() == Chunk::Float_32 && header.dimensions() == 3;
        if (header.type() == Chunk::Type_Pos) {
            if (!floats) fail("the places are of an unusual type", "three 4-byte floats each");
            return once(has_places_);
        }
        if (header.type() == Chunk::Type_Normal) {
            if (!floats) other_normals_ = true;
            return floats && once(has_normals_);
        }
        const bool bytes = !header.is_float() && header.integer_bytes() == 1 && header.dimensions() == 3;
        if (header.type() != Chunk::Type_Color) return false;
        if (!bytes) other_colors_ = true;
        return bytes && once(has_colors_);
    }

    std::string_view bytes_;
    const std::string& file_;
    ParsedBytes parsed_;
    char kind_ = 'P';
    unsigned version_ = 0;
    std::size_t vertices_ = 0, faces_ = 0, edges_ = 0, at_ = 0;
    bool has_places_ = false, has_normals_ = false, has_colors_ = false, has_faces_ = false,
         has_halfedges_ = false, other_normals_ = false, other_colors_ = false;
};

}  // namespace

std::string sound_om_chunks(std::string_view bytes, const std::string& file, Warnings& warnings) {
    return ChunkFilter(bytes, file).sound(warnings);
}

}  // namespace glint
