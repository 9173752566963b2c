// Wavefront .obj. We use our own reader, because OpenMesh's drops per-corner normals and does not report line
// numbers.
// Source: Wavefront, "Advanced Visualizer" manual, appendix B1 (object files).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <limits>

#include "models/mesh/formats/mesh_reader.h"

namespace glint {
namespace {

/// A corner that refers to a vertex not yet defined.
struct AheadOfVertex {
    std::int64_t index;
    int line;
};

// Statements about grouping and display, which do not affect the shape.
constexpr std::array<std::string_view, 13> silent{"vt",         "g",         "o",     "mtllib",   "usemap",
                                                  "maplib",     "lod",       "bevel", "c_interp", "d_interp",
                                                  "shadow_obj", "trace_obj", "ctech"};
// Free-form curves and surfaces, superseded statements, calls, and additions by other programs: bone weights,
// subdivision tags.
constexpr std::array<std::string_view, 26> rare{
    "vp",  "cstype", "deg",   "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp",
    "end", "con",    "stech", "mg",   "bsp",  "bzp",  "cdc",   "cdp",  "res",  "call", "csh",  "vw",   "t"};

template <std::size_t N> bool has(const std::array<std::string_view, N>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
  public:
    ObjReader(std::string_view bytes, const std::string& file, const glm::dvec3& offset)
        : cursor_(bytes, file, true), file_(file), offset_(offset) {
        mesh_.first_corner.push_back(0);
    }

    Mesh read() {
        while (cursor_.next_line()) statement(cursor_.word());
        check_ahead();
        finish_normals();
        if (!mesh_.colors.empty()) mesh_.colors.resize(mesh_.positions.size(), glm::vec3(1));
        finish_smoothing();
        warn(mesh_.warnings, slashes_, "corner ends in a slash, which is ignored",
             "corners end in a slash, which is ignored");
        warn(mesh_.warnings, weights_, "vertex has a weight, which is ignored",
             "vertices have weights, which are ignored");
        warn(mesh_.warnings, lines_, "line element is ignored", "line elements are ignored");
        warn(mesh_.warnings, points_, "point element is ignored", "point elements are ignored");
        const std::string names = fmt::format("({})", fmt::join(rare_names_, ", "));
        warn(mesh_.warnings, rare_count_, "statement is ignored " + names, "statements are ignored " + names);
        warn(mesh_.warnings, materials_, "material of a .mtl file is not read",
             "materials of .mtl files are not read");
        return std::move(mesh_);
    }

  private:
    void statement(std::string_view keyword) {
        if (keyword == "v") return vertex();
        if (keyword == "f" || keyword == "fo") return face();  // "fo" is the older name
        if (keyword == "vn") return normal();
        if (keyword == "s") return smoothing_group();
        if (has(silent, keyword)) return;
        if (keyword == "l") {
            ++lines_;
        } else if (keyword == "p") {
            ++points_;
        } else if (keyword == "usemtl") {
            ++materials_;
        } else if (has(rare, keyword)) {
            ++rare_count_;
            if (std::find(rare_names_.begin(), rare_names_.end(), keyword) == rare_names_.end())
                rare_names_.push_back(keyword);
        } else {
            cursor_.fail(fmt::format("{} is not an OBJ statement", quoted_word(keyword)),
                         "v, vt, vn, f, l, p, g, o, s, usemtl or mtllib");
        }
    }

    /// x y z, then nothing, a weight, or a colour with or without alpha.
    void vertex() {
        mesh_.positions.push_back(cursor_.position(offset_));
        if (cursor_.end_of_line()) return;
        glm::vec3 color(1);
        color.r = cursor_.number("a number");
        if (cursor_.end_of_line()) {
            ++weights_;
            return;
        }
        color.g = cursor_.number("a colour's green component");
        color.b = cursor_.number("a colour's blue component");
        if (!cursor_.end_of_line()) static_cast<void>(cursor_.number("alpha"));
        cursor_.end_line("3, 4, 6 or 7 numbers after \"v\"");
        mesh_.colors.resize(mesh_.positions.size() - 1, glm::vec3(1));  // white for the earlier vertices
        mesh_.colors.push_back(color);
    }

    void normal() {
        mesh_.normals.push_back(cursor_.normal());
        cursor_.end_line("3 numbers after \"vn\"");
    }

    /// Reads a smoothing group. After "off" or 0, faces are not smooth.
    void smoothing_group() {
        std::string_view word = cursor_.word();
        std::uint32_t group = 0;
        const auto [last, error] = std::from_chars(word.data(), word.data() + word.size(), group);
        if (word == "on") group = 1;
        if (word != "off" && word != "on" && (error != std::errc() || last != word.data() + word.size()))
            cursor_.fail(fmt::format("{} is not a smoothing group", quoted_word(word)), "a number, or off");
        mesh_.smoothing.resize(mesh_.face_count(), group_);
        group_ = group;
        has_groups_ = true;
    }

    void face() {
        if (cursor_.end_of_line()) cursor_.fail("a face has no corners", "at least 3 after \"f\"");
        while (!cursor_.end_of_line()) corner(cursor_.word());
        close_face(mesh_, file_, cursor_.line());
    }

    /// "v", "v/vt", "v//vn" or "v/vt/vn"; some writers leave slashes without an index at the end.
    void corner(std::string_view word) {
        const char* at = word.data();
        const char* end = at + word.size();
        std::int64_t vertex = 0, texture = 0, normal = 0;
        bool good = integer(at, end, vertex);
        bool has_normal = false;
        if (good && at < end && *at == '/') {
            ++at;
            bool is_open = at == end;
            if (at < end && *at != '/') good = integer(at, end, texture);
            if (good && at < end && *at == '/') {
                ++at;
                is_open = at == end;
                if (!is_open) good = has_normal = integer(at, end, normal);
            }
            slashes_ += is_open ? 1 : 0;
        }
        if (!good || at != end)
            cursor_.fail(fmt::format("{} is not a corner of a face", quoted_word(word)),
                         "v, v/vt, v//vn or v/vt/vn");
        add_vertex(vertex);
        if (has_normal) add_normal(normal);
    }

    static bool integer(const char*& at, const char* end, std::int64_t& value) {
        const auto [last, error] = std::from_chars(at, end, value);
        if (error == std::errc::result_out_of_range) value = *at == '-' ? -beyond : beyond;
        at = last;
        return error != std::errc::invalid_argument;
    }

    void add_vertex(std::int64_t index) {
        const auto count = static_cast<std::int64_t>(mesh_.positions.size());
        const std::int64_t from_zero = index < 0 ? count + index : index - 1;
        if (from_zero < 0 || index > std::int64_t{no_index}) fail_vertex({index, cursor_.line()});
        if (from_zero >= count && (ahead_.empty() || index > ahead_.back().index))
            ahead_.push_back({index, cursor_.line()});
        mesh_.corner_position.push_back(static_cast<std::uint32_t>(from_zero));
    }

    /// Adds a corner's normal. If the file never defines it, the corner has no normal. It may still be
    /// defined later, so this is decided at the end.
    void add_normal(std::int64_t index) {
        const auto count = static_cast<std::int64_t>(mesh_.normals.size());
        const std::int64_t from_zero = index < 0 ? count + index : index - 1;
        const bool possible = from_zero >= 0 && from_zero < std::int64_t{no_index};
        ++named_normals_;
        mesh_.corner_normal.resize(mesh_.corner_position.size() - 1, no_index);
        mesh_.corner_normal.push_back(possible ? static_cast<std::uint32_t>(from_zero) : no_index);
    }

    [[noreturn]] void fail_vertex(const AheadOfVertex& corner) const {
        const std::size_t count = mesh_.positions.size();
        std::string expected = count == 0 ? "vertices before it" : fmt::format("1 to {}", count);
        if (corner.index < 0 && count > 0) expected = fmt::format("-1 to -{}, or {}", count, expected);
        const std::string which = std::abs(corner.index) == beyond
                                      ? "a vertex index beyond 64 bits"
                                      : fmt::format("vertex index {}", corner.index);
        cursor_.fail_at(corner.line, which + " is out of range", expected);
    }

    void check_ahead() const {
        for (const AheadOfVertex& corner : ahead_)
            if (corner.index > static_cast<std::int64_t>(mesh_.positions.size())) fail_vertex(corner);
    }

    /// Drops a single group that contains all faces: a mesh without groups is drawn the same way.
    void finish_smoothing() {
        auto& groups = mesh_.smoothing;
        if (!has_groups_) return;
        groups.resize(mesh_.face_count(), group_);
        const bool is_one =
            std::adjacent_find(groups.begin(), groups.end(), std::not_equal_to<>()) == groups.end();
        if (is_one && !groups.empty() && groups[0] != 0) groups = {};
    }

    void finish_normals() {
        if (mesh_.normals.empty() || mesh_.corner_normal.empty()) {
            mesh_.normals.clear();
            mesh_.corner_normal.clear();
            warn(mesh_.warnings, named_normals_,
                 "corner names a normal, but the file has none; its vertex normal is used",
                 "corners name normals, but the file has none; their vertex normals are used");
            return;
        }
        mesh_.given_normals = GivenNormals::File;  // corner_normals() counts the corners without one
        mesh_.corner_normal.resize(mesh_.corner_position.size(), no_index);
        for (std::uint32_t& index : mesh_.corner_normal)
            if (index >= mesh_.normals.size()) index = no_index;
        const bool by_position =
            mesh_.normals.size() == mesh_.positions.size() && mesh_.corner_normal == mesh_.corner_position;
        mesh_.has_own_normal_indices = !by_position;
        if (by_position) mesh_.corner_normal = {};
    }

    // The value used for an index that exceeds 64 bits.
    static constexpr std::int64_t beyond = std::numeric_limits<std::int64_t>::max();

    TextCursor cursor_;
    const std::string& file_;
    const glm::dvec3& offset_;
    Mesh mesh_;
    // Corners that refer to a vertex that has not been read yet, each with a larger index than the one
    // before. The first corner whose vertex is never defined is always among them.
    std::vector<AheadOfVertex> ahead_;
    std::size_t named_normals_ = 0, slashes_ = 0, weights_ = 0, lines_ = 0, points_ = 0, materials_ = 0,
                rare_count_ = 0;
    std::vector<std::string_view> rare_names_;
    std::uint32_t group_ = 0;  // the current smoothing group
    bool has_groups_ = false;
};

}  // namespace

Mesh read_obj(std::string_view bytes, const std::string& file, const glm::dvec3& offset) {
    return ObjReader(bytes, file, offset).read();
}

}  // namespace glint
