// Stereolithography .stl, ASCII and binary. The format has no indices: corners at exactly the same position
// share it, so adjacent facets are connected. The facet normals are the file's normals; some writers set them
// all to 0, which counts as having none. Source: 3D Systems, "StereoLithography Interface Specification",
// 1989.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "models/mesh/formats/mesh_reader.h"

namespace glint {
namespace {

/// Collects the facets of either kind of file.
class Facets {
  public:
    Facets(const std::string& file, const glm::dvec3& offset) : file_(file), offset_(offset) {
        mesh_.first_corner.push_back(0);
    }

    void corner(const glm::vec3& place) {
        mesh_.corner_position.push_back(places_.index_of(place, mesh_.positions));
    }
    void close(const glm::vec3& normal, int line) {
        close_face(mesh_, file_, line);
        const auto index = static_cast<std::uint32_t>(mesh_.normals.size());
        mesh_.normals.push_back(normal);
        mesh_.corner_normal.resize(mesh_.corner_position.size(), index);
    }
    Mesh finish() {
        drop_bad_normals(mesh_);
        const auto is_given = [](const glm::vec3& n) { return n != glm::vec3(0); };
        if (std::any_of(mesh_.normals.begin(), mesh_.normals.end(), is_given)) {
            mesh_.given_normals = GivenNormals::File;
        } else {
            mesh_.normals = {};
            mesh_.corner_normal = {};
        }
        return std::move(mesh_);
    }
    [[nodiscard]] const glm::dvec3& offset() const { return offset_; }
    Warnings& warnings() { return mesh_.warnings; }

  private:
    const std::string& file_;
    const glm::dvec3& offset_;
    Mesh mesh_;
    Places places_;
};

Mesh read_binary(std::string_view bytes, const std::string& file, const glm::dvec3& offset) {
    const std::size_t count = binary_stl_facets(bytes);
    Facets facets(file, offset);
    ParsedBytes parsed(bytes.size());
    for (std::size_t f = 0; f < count; ++f) {
        parsed.at(f * binary_stl_facet);
        const char* at = bytes.data() + binary_stl_header + f * binary_stl_facet;
        std::array<glm::vec3, 4> v;  // normal, three corners
        for (int i = 0; i < 12; ++i, at += 4) {
            const float x = little_endian_float(at);
            if (i >= 3 && !(std::abs(x) <= static_cast<float>(max_number)))
                throw ProblemFound(
                    {file, "", fmt::format("facet {}: a coordinate is {}", f, x), "-1e7 to 1e7", 0});
            v[static_cast<std::size_t>(i / 3)][i % 3] = x;
        }
        for (const std::size_t i : {1u, 2u, 3u}) facets.corner(glm::vec3(glm::dvec3(v[i]) - offset));
        facets.close(v[0], 0);
    }
    if (bytes.size() > binary_stl_header + count * binary_stl_facet)
        facets.warnings().emplace_back("data after the last facet is ignored");
    return facets.finish();
}

class AsciiStl {
  public:
    AsciiStl(std::string_view bytes, const std::string& file, const glm::dvec3& offset)
        : cursor_(bytes, file, false), facets_(file, offset) {}

    Mesh read() {
        while (cursor_.next_line()) {
            if (is("solid", cursor_.word()))
                read_solid();
            else
                cursor_.fail("this is not an STL file", "\"solid\", or a binary file of 84 + 50 n bytes");
        }
        return facets_.finish();
    }

  private:
    static bool is(std::string_view keyword, std::string_view word) {
        return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                          [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
    }

    /// Moves to the next word on any line: within a solid, a line end is ordinary white space.
    bool is_at_word() { return !cursor_.end_of_line() || cursor_.next_line(); }

    void expect(std::string_view keyword) {
        const std::string_view word = is_at_word() ? cursor_.word() : std::string_view();
        if (!is(keyword, word)) fail(word, fmt::format("\"{}\"", keyword));
    }

    [[noreturn]] void fail(std::string_view word, std::string expected) const {
        cursor_.fail(
            word.empty() ? "the file ends early" : fmt::format("{} is out of place", quoted_word(word)),
            std::move(expected));
    }

    /// Reads up to "endsolid"; the text after "solid" and "endsolid" is a name.
    void read_solid() {
        bool is_more = cursor_.next_line();
        for (; is_more; is_more = is_at_word()) {
            const std::string_view word = cursor_.word();
            if (is("endsolid", word)) return;
            if (!is("facet", word)) fail(word, "\"facet\" or \"endsolid\"");
            read_facet();
        }
        fail({}, "\"facet\" or \"endsolid\"");
    }

    void read_facet() {
        expect("normal");
        const glm::vec3 normal = only_three(cursor_.normal());
        expect("outer");
        expect("loop");
        for (int i = 0; i < 3; ++i) {
            expect("vertex");
            facets_.corner(only_three(cursor_.position(facets_.offset())));
        }
        expect("endloop");
        expect("endfacet");
        facets_.close(normal, cursor_.line());
    }

    /// Rejects a fourth number here: read as the next keyword, it would cause a misleading message.
    glm::vec3 only_three(const glm::vec3& v) {
        constexpr std::string_view of_numbers = "+-.0123456789";
        if (!cursor_.end_of_line() && of_numbers.find(cursor_.rest().front()) != std::string_view::npos)
            cursor_.end_line("3 numbers");
        return v;
    }

    TextCursor cursor_;
    Facets facets_;
};

}  // namespace

bool begins_as_text_stl(std::string_view bytes) {
    const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const std::string_view word = bytes.substr(first, 5);
    return (word == "solid" || word == "SOLID" || word == "Solid") &&
           bytes.substr(0, binary_stl_header).find('\0') == bytes.npos;
}

std::size_t binary_stl_facets(std::string_view bytes) { return little_endian(&bytes[80], 4); }

std::size_t binary_stl_size(std::string_view bytes) {
    if (bytes.size() < binary_stl_header) return 0;
    return binary_stl_header + binary_stl_facets(bytes) * binary_stl_facet;
}

Mesh read_stl(std::string_view bytes, const std::string& file, const glm::dvec3& offset) {
    // The file size decides whether a file is binary, because some binary files have spaces instead of zeros.
    const std::size_t promised = binary_stl_size(bytes);
    if (bytes.size() == promised) return read_binary(bytes, file, offset);
    if (begins_as_text_stl(bytes)) return AsciiStl(bytes, file, offset).read();
    if (promised > 0 && bytes.size() > promised) return read_binary(bytes, file, offset);
    throw ProblemFound({file, "", "this is not an STL file, or it ends early",
                        promised > 0
                            ? fmt::format("{} bytes for its {} facets", promised, binary_stl_facets(bytes))
                            : std::string("\"solid\", or a binary file of 84 + 50 n bytes"),
                        0});
}

}  // namespace glint
