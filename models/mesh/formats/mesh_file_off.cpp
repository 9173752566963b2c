// Object File Format, ASCII: OFF, COFF (vertex colours), NOFF (vertex normals), CNOFF (both).
// Common variations: no keyword, the counts right after the keyword ("OFF3 1 0", as in ModelNet), and colours
// not announced by the keyword. Source: Geomview manual, "OFF: Object File Format".
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "models/mesh/formats/mesh_reader.h"

namespace glint {
namespace {

struct OffKind {
    std::string_view keyword;
    bool colors, normals;
};
constexpr std::array<OffKind, 5> kinds{{{"OFF", false, false},
                                        {"COFF", true, false},
                                        {"NOFF", false, true},
                                        {"CNOFF", true, true},
                                        {"", false, false}}};

class OffReader {
  public:
    OffReader(std::string_view bytes, const std::string& file, const glm::dvec3& offset)
        : cursor_(bytes, file, false), file_(file), offset_(offset) {
        mesh_.first_corner.push_back(0);
    }

    Mesh read() {
        read_header();
        mesh_.positions.reserve(std::min(vertex_count_, cursor_.rest().size() / 5));  // the shortest: "0 0 0"
        for (std::size_t v = 0; v < vertex_count_; ++v) read_vertex(v);
        for (std::size_t f = 0; f < face_count_; ++f) read_face(f);
        if (cursor_.next_line()) mesh_.warnings.emplace_back("data after the last face is ignored");
        warn(mesh_.warnings, face_colors_, "face has a colour, which is ignored",
             "faces have colours, which are ignored");
        scale_colors();
        if (normals_) mesh_.given_normals = GivenNormals::File;
        return std::move(mesh_);
    }

  private:
    void read_header() {
        const char* expected = "OFF, COFF, NOFF or CNOFF";
        if (!cursor_.next_line()) cursor_.fail("this is not an OFF file", expected);
        const std::string_view word = TextCursor(cursor_).word();
        const auto* kind = std::find_if(kinds.begin(), kinds.end(), [&](const OffKind& k) {
            return word.starts_with(k.keyword) &&
                   word.find_first_not_of("0123456789", k.keyword.size()) == std::string_view::npos;
        });
        if (kind == kinds.end())
            cursor_.fail(fmt::format("{} is not a supported kind of OFF file", quoted_word(word)), expected);
        colors_ = kind->colors;
        normals_ = kind->normals;
        cursor_.skip(kind->keyword);
        if (cursor_.end_of_line()) {
            if (!cursor_.next_line()) cursor_.fail("the file ends early", "the counts of vertices and faces");
        } else if (TextCursor ahead = cursor_; ahead.word() == "BINARY") {
            cursor_.fail("binary OFF is not supported", "an ASCII file");
        }
        vertex_count_ = count("the vertex count");
        face_count_ = count("the face count");
        if (!cursor_.end_of_line()) static_cast<void>(cursor_.integer("the edge count"));
        cursor_.end_line("the counts of vertices, faces and edges");
    }

    std::size_t count(const char* name) {
        const std::int64_t value = cursor_.integer(name);
        if (value < 0 || value > static_cast<std::int64_t>(max_corners))
            cursor_.fail(fmt::format("{} is {}", name, value), fmt::format("0 to {}", max_corners));
        return static_cast<std::size_t>(value);
    }

    void next_row(const char* what, std::size_t row, std::size_t of) {
        if (!cursor_.next_line())
            cursor_.fail(fmt::format("the file ends after {} {}", row, what), fmt::format("{}", of));
    }

    void read_vertex(std::size_t row) {
        next_row("vertices", row, vertex_count_);
        mesh_.positions.push_back(cursor_.position(offset_));
        if (normals_)
            mesh_.normals.push_back(cursor_.normal({"a normal's x", "a normal's y", "a normal's z"}));
        if (colors_ || !cursor_.end_of_line()) {
            mesh_.colors.resize(row, no_color);
            const std::string_view before = cursor_.rest();
            mesh_.colors.push_back(cursor_.three({"red", "green", "blue"}));
            const std::string_view text = before.substr(0, before.size() - cursor_.rest().size());
            whole_colors_ = whole_colors_ && text.find_first_of(".eE") == std::string_view::npos;
            const glm::vec3& c = mesh_.colors.back();
            brightest_ = std::max({brightest_, c.r, c.g, c.b});
            if (!cursor_.end_of_line()) static_cast<void>(cursor_.number("alpha"));
        }
        cursor_.end_line("x y z, a normal for NOFF, then a colour or nothing");
    }

    void read_face(std::size_t row) {
        next_row("faces", row, face_count_);
        const std::int64_t corners = cursor_.integer("a face's corner count");
        if (corners < 0) cursor_.fail(fmt::format("a face has {} corners", corners), "0 or more");
        for (std::int64_t c = 0; c < corners; ++c) {
            const std::int64_t index = cursor_.integer("a vertex index");
            if (index < 0 || index >= static_cast<std::int64_t>(vertex_count_))
                cursor_.fail(fmt::format("vertex index {} is out of range", index),
                             numbers_of(vertex_count_, "vertices"));
            mesh_.corner_position.push_back(static_cast<std::uint32_t>(index));
        }
        close_face(mesh_, file_, cursor_.line());
        face_colors_ += cursor_.end_of_line() ? 0 : 1;
    }

    /// Integer colours range from 0 to 255 if any of them is above 1; all others are already fractions.
    /// Vertices without a colour are white.
    void scale_colors() {
        if (mesh_.colors.empty()) return;
        mesh_.colors.resize(vertex_count_, no_color);
        const float largest = whole_colors_ && brightest_ > 1 ? 255.f : 1.f;
        for (glm::vec3& c : mesh_.colors) c = std::isnan(c.r) ? glm::vec3(1) : c / largest;
    }

    static constexpr glm::vec3 no_color{std::numeric_limits<float>::quiet_NaN()};

    TextCursor cursor_;
    const std::string& file_;
    const glm::dvec3& offset_;
    Mesh mesh_;
    bool colors_ = false, normals_ = false, whole_colors_ = true;
    float brightest_ = 0;
    std::size_t vertex_count_ = 0, face_count_ = 0, face_colors_ = 0;
};

}  // namespace

Mesh read_off(std::string_view bytes, const std::string& file, const glm::dvec3& offset) {
    return OffReader(bytes, file, offset).read();
}

}  // namespace glint
