#include "models/mesh/formats/mesh_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <limits>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "models/io/file.h"
#include "models/mesh/formats/mesh_reader.h"
#include "models/progress.h"
#include "models/utf8.h"

namespace glint {
namespace {

using Reader = Mesh (*)(std::string_view, const std::string&, const glm::dvec3&);
struct Format {
    std::string_view extension;
    Reader read;
};
constexpr std::array<Format, 4> formats{
    {{".obj", read_obj}, {".ply", read_ply}, {".off", read_off}, {".stl", read_stl}}};

/// The format for a path's extension, ignoring case; null if there is none.
const Format* format_of(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] == '/') return nullptr;
    std::string extension = path.substr(dot);
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const auto* found = std::find_if(formats.begin(), formats.end(),
                                     [&](const Format& f) { return f.extension == extension; });
    return found == formats.end() ? nullptr : found;
}

/// Returns the beginning of a file, without the byte-order mark that a text may have.
std::string_view without_mark(std::string_view extension, const FileBlock& first) {
    const std::string_view text = without_byte_order_mark(first.bytes);
    const bool is_binary =
        extension == ".stl" && (!begins_as_text_stl(text) || binary_stl_size(first.bytes) == first.size);
    return is_binary ? first.bytes : text;
}

/// Sets negative colour channels to 0, because they would subtract light.
void raise_colors_to_black(Mesh& mesh) {
    std::size_t below = 0;
    for (glm::vec3& color : mesh.colors) {
        if (color.r >= 0 && color.g >= 0 && color.b >= 0) continue;
        color = glm::max(color, glm::vec3(0));
        ++below;
    }
    warn(mesh.warnings, below, "vertex has a colour with a channel below 0, which is treated as 0",
         "vertices have colours with a channel below 0, which is treated as 0");
}

/// Whether a file with this first block is entirely text.
bool is_text_mesh(std::string_view extension, const FileBlock& first) {
    if (extension == ".ply") return first.bytes.find("format ascii") != std::string_view::npos;
    if (extension != ".stl") return true;
    return begins_as_text_stl(without_mark(extension, first)) && binary_stl_size(first.bytes) != first.size;
}

/// Whether a file stores 32-bit floats, which are imprecise far from the origin.
bool stores_floats(std::string_view extension, std::string_view bytes) {
    const std::string_view header = bytes.substr(0, bytes.find("end_header"));
    return !is_text_mesh(extension, {bytes, 0, bytes.size()}) && header.find("double x") == header.npos &&
           header.find("float64 x") == header.npos;
}

Result<Mesh> parse_since(std::chrono::steady_clock::time_point start, std::string_view bytes,
                         const std::string& path) {
    const Format* format = format_of(path);
    if (format == nullptr)
        return Problem{path, "", "the extension is not that of a mesh file", ".obj, .ply, .off or .stl"};
    if (bytes.empty()) return Problem{path, "", "the file is empty", "a mesh", 0};
    return result_of(path, [&]() -> Result<Mesh> {
        const std::string_view text = without_mark(format->extension, {bytes, 0, bytes.size()});
        Mesh mesh = format->read(text, path, {});
        if (mesh.face_count() == 0) return Problem{path, "", "the mesh has no faces", "at least one", 0};
        const Bounds given = bounds_of_faces(mesh);
        if (const glm::dvec3 offset = far_offset(given); offset != glm::dvec3(0)) {
            mesh = format->read(text, path, offset);
            for (glm::vec3& p : mesh.positions)  // positions that no face uses may be out of range
                p = glm::clamp(p, static_cast<float>(-max_number), static_cast<float>(max_number));
            mesh.offset = offset;
            mesh.warnings.push_back(offset_warning(offset));
            if (auto rounded = rounding_warning(given); rounded && stores_floats(format->extension, bytes))
                mesh.warnings.push_back(std::move(*rounded));
        }
        drop_bad_normals(mesh);
        raise_colors_to_black(mesh);
        if (format->read != read_stl) find_places(mesh);  // read_stl() has merged equal positions
        finish_mesh(mesh);
        if (auto warning = rounding_warning(mesh.bounds)) mesh.warnings.push_back(std::move(*warning));
        const auto time = std::chrono::steady_clock::now() - start;
        mesh.load_ms = std::chrono::duration<double, std::milli>(time).count();
        return mesh;
    });
}

/// True if the first block is not a valid beginning of a file with that extension: the reader will fail
/// within that block.
bool begins_badly(std::string_view extension, const FileBlock& first) {
    const std::string_view bytes = without_mark(extension, first);
    if (extension == ".ply") return !bytes.starts_with("ply");
    if (extension == ".stl" && bytes.size() >= binary_stl_header && !begins_as_text_stl(bytes))
        return binary_stl_facets(bytes) == 0 || binary_stl_size(bytes) > first.size;
    const std::size_t word = bytes.find_first_not_of(" \t\r\n\v\f");
    return word != std::string_view::npos && bytes[word] == '\0';
}

/// Whether the block is all zero bytes, like a hole in a sparse file, and longer than a line of text could
/// be.
bool is_hole(const FileBlock& block) {
    constexpr std::size_t shortest = 4096;
    return block.bytes.size() >= shortest && block.bytes.find_first_not_of('\0') == std::string_view::npos;
}

/// Checks a mesh file block by block while it is read, so that files of other kinds are rejected early.
class MeshCheck {
  public:
    explicit MeshCheck(const std::string& path) : path_(path) {}

    std::optional<Problem> operator()(const FileBlock& block) {
        const Format* format = format_of(path_);
        if (format == nullptr) return {};  // the parser reports it
        if (block.at == 0) {
            if (begins_badly(format->extension, block)) {
                const Result<Mesh> tried = parse_mesh(block.bytes, path_);
                if (const Problem* problem = problem_of(tried)) return *problem;
            }
            text_ = is_text_mesh(format->extension, block);
        }
        if (text_ && is_hole(block))
            return Problem{path_, "", fmt::format("there are only zero bytes from byte {} on", block.at),
                           "text", 0};
        return {};
    }

  private:
    const std::string& path_;
    bool text_ = false;
};

}  // namespace

bool is_mesh_path(const std::string& path) { return format_of(path) != nullptr; }

Result<Mesh> read_mesh(const std::string& path) {
    const auto start = std::chrono::steady_clock::now();
    MeshCheck check(path);
    const Result<std::string> bytes = read_file(path, max_mesh_file_bytes, std::ref(check));
    if (const Problem* problem = problem_of(bytes)) return *problem;
    return parse_since(start, std::get<std::string>(bytes), path);
}

Result<Mesh> parse_mesh(std::string_view bytes, const std::string& path) {
    return parse_since(std::chrono::steady_clock::now(), bytes, path);
}

std::string numbers_of(std::size_t count, const char* things) {
    return count == 0 ? things : fmt::format("0 to {}", count - 1);
}

void find_places(Mesh& mesh) {
    Places places(mesh.positions.size());
    std::vector<glm::vec3> distinct;
    distinct.reserve(mesh.positions.size());
    std::vector<std::uint32_t> first, first_of;  // `first` is indexed by vertex, `first_of` like `distinct`
    first.reserve(mesh.positions.size());
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const std::uint32_t place = places.index_of(mesh.positions[v], distinct);
        if (place == first_of.size()) first_of.push_back(v);
        first.push_back(first_of[place]);
    }
    if (distinct.size() < mesh.positions.size()) mesh.first_at_place = std::move(first);
}

void drop_bad_normals(Mesh& mesh) {
    std::size_t bad = 0;
    const auto good = [](float x) { return std::abs(x) <= static_cast<float>(max_number); };
    for (glm::vec3& n : mesh.normals) {
        if (good(n.x) && good(n.y) && good(n.z)) continue;
        n = glm::vec3(0);
        ++bad;
    }
    mesh.bad_normals += bad;
    warn(mesh.warnings, bad, "normal is not finite and is treated as missing",
         "normals are not finite and are treated as missing");
}

void close_face(Mesh& mesh, const std::string& file, int line) {
    if (mesh.corner_position.size() > max_corners)
        throw ProblemFound(
            {file, "", "the mesh has too many corners", fmt::format("at most {}", max_corners), line});
    mesh.first_corner.push_back(static_cast<std::uint32_t>(mesh.corner_position.size()));
}

void TextCursor::fail_at(int line, std::string what, std::string expected) const {
    throw ProblemFound({file_, "", std::move(what), std::move(expected), line});
}

void TextCursor::fail_missing(std::string_view name, const char* expected) const {
    fail(fmt::format("{} is missing", name), expected);
}

void TextCursor::fail_integer() {
    const std::string_view text = word();
    const bool digits = text.find_first_not_of("-0123456789") == std::string_view::npos;
    fail(fmt::format("{} is {}", quoted_word(text), digits ? "out of range" : "not a whole number"),
         "a whole number");
}

void TextCursor::fail_too_many(const char* expected) {
    fail(fmt::format("{} is one too many", quoted_word(word())), expected);
}

/// The position after the line end at `at`. CR LF and LF CR count as one, but the CR in LF CR LF belongs to
/// CR LF.
const char* TextCursor::after_line_end(const char* at) const {
    const auto is = [this](const char* p, char c) { return p < end_ && *p == c; };
    if (*at == '\r') return at + (is(at + 1, '\n') ? 2 : 1);
    return at + (is(at + 1, '\r') && !is(at + 2, '\n') ? 2 : 1);
}

/// Skips the rest of this line and the lines that a backslash joins to it.
void TextCursor::skip_rest() {
    while (at_ < end_) {
        const char* found = std::find_if(at_, end_, is_line_end);
        const bool joined = continued_ && found > at_ && found[-1] == '\\';
        at_ = found == end_ ? end_ : after_line_end(found);
        if (found == end_) return;
        ++line_;
        if (!joined) return;
    }
}

/// At a backslash, moves past the line end that it cancels; returns false if another character follows.
bool TextCursor::skip_continuation() {
    const char* next = at_ + 1;
    if (next < end_ && !is_line_end(*next)) return false;
    if (next < end_) ++line_;
    at_ = (next < end_ ? after_line_end(next) : end_) - 1;  // the caller advances by one
    return true;
}

/// The slow path after from_chars(): reports the error, or returns 0 for a number too small for a float. A
/// normal becomes NaN instead of causing an error, because Microsoft's libraries write "1.#IND" and
/// "1.#QNAN".
float TextCursor::unusual_number(bool of_normal) {
    const std::string_view text = word();
    const bool plus = text.starts_with('+') && !text.starts_with("+-");
    const std::string_view digits = text.substr(plus ? 1 : 0);
    double value = 0;
    const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = last == digits.data() + digits.size() && error != std::errc::invalid_argument;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    if (of_normal && ((whole && std::isnan(value)) || digits.find(".#") != std::string_view::npos))
        return nan;
    if (!whole || std::isnan(value)) fail(fmt::format("{} is not a number", quoted_word(text)), "a number");
    if (error == std::errc() && std::abs(value) <= max_number) return static_cast<float>(value);
    const std::size_t exponent = std::min(digits.find_first_of("eE"), digits.size());
    const bool tiny = digits.size() < 64 && digits.substr(exponent, 2).find('-') != std::string_view::npos;
    if (error == std::errc::result_out_of_range && tiny) return 0;
    if (of_normal) return nan;
    fail(fmt::format("{} is out of range", quoted_word(text)), "-1e7 to 1e7");
}

std::string quoted_word(std::string_view word) {
    constexpr std::size_t longest = 24;  // bytes; longer numbers have superfluous digits
    if (word.size() <= longest && on_one_line(word) == word) return fmt::format("\"{}\"", word);
    return fmt::format("a word of {} byte{}", word.size(), word.size() == 1 ? "" : "s");
}

}  // namespace glint
