// Stanford .ply: ASCII, and binary in both byte orders, properties in any order and of any type.
// Source: G. Turk, "The PLY Polygon File Format", 1994.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <optional>
#include <set>
#include <string_view>

#include "models/mesh/formats/mesh_reader.h"

namespace glint {
namespace {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
enum class PlyFormat { Ascii, LittleEndian, BigEndian };

/// The meaning of a property to this reader.
enum class PlyRole { Other, X, Y, Z, Nx, Ny, Nz, Red, Green, Blue, Indices };
constexpr std::size_t ply_role_count = 11;
constexpr bool is_position(PlyRole role) { return role >= PlyRole::X && role <= PlyRole::Z; }
constexpr bool is_normal(PlyRole role) { return role >= PlyRole::Nx && role <= PlyRole::Nz; }

/// The limit on the total number of elements and properties in a header. Real files have a few dozen.
constexpr std::size_t max_ply_names = 65536;

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool is_list = false;
    PlyType count_type = PlyType::Uint8;  // for lists only
    PlyRole role = PlyRole::Other;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
    int line = 0;

    void add(PlyProperty property) {
        std::size_t& number = number_of_[static_cast<std::size_t>(property.role)];
        properties.push_back(std::move(property));
        if (number == 0) number = properties.size();
    }
    /// The first property with that role; null if there is none. Precondition: the role is not Other.
    [[nodiscard]] const PlyProperty* with(PlyRole role) const {
        const std::size_t number = number_of_[static_cast<std::size_t>(role)];
        return number == 0 ? nullptr : &properties[number - 1];
    }
    /// True if the three roles starting with `first` all exist, as single values.
    [[nodiscard]] bool has_three(PlyRole first) const { return count_of_three(first) == 3; }
    /// True if only one or two of the three roles exist.
    [[nodiscard]] bool has_part_of_three(PlyRole first) const {
        return count_of_three(first) > 0 && !has_three(first);
    }

  private:
    [[nodiscard]] int count_of_three(PlyRole first) const {
        int there = 0;
        for (int i = 0; i < 3; ++i)
            there += with(static_cast<PlyRole>(static_cast<int>(first) + i)) != nullptr ? 1 : 0;
        return there;
    }

    std::array<std::size_t, ply_role_count> number_of_{};  // 1 + the index of the role's property; 0: none
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::string line_end;      // the end of the first line: LF, CR, CR LF or LF CR
    std::size_t textures = 0;  // the number of textures named in comments, as MeshLab does
    glm::dvec3 offset{0};      // set by the reader; subtracted from positions
};

/// The two names of each PlyType, in enumerator order.
constexpr std::array<std::array<std::string_view, 2>, 8> type_names{{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
/// The names of a vertex's properties, in the order of PlyRole, starting at X.
constexpr std::array<std::string_view, 9> vertex_roles{"x",  "y",   "z",     "nx",  "ny",
                                                       "nz", "red", "green", "blue"};

PlyFormat read_format(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    if (word == "ascii") return PlyFormat::Ascii;
    if (word == "binary_little_endian") return PlyFormat::LittleEndian;
    if (word == "binary_big_endian") return PlyFormat::BigEndian;
    cursor.fail(fmt::format("{} is not a PLY format", quoted_word(word)),
                "ascii, binary_little_endian or binary_big_endian");
}

bool is_integer(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

PlyRole role_of(std::string_view element, const PlyProperty& property) {
    const bool has_corners = element == "face" || element == "tristrips";
    if (has_corners && (property.name == "vertex_indices" || property.name == "vertex_index"))
        return PlyRole::Indices;
    if (element != "vertex" && element != "face") return PlyRole::Other;
    const auto* const found = std::find(vertex_roles.begin(), vertex_roles.end(), property.name);
    if (found == vertex_roles.end() || property.is_list) return PlyRole::Other;
    return static_cast<PlyRole>(static_cast<int>(PlyRole::X) + (found - vertex_roles.begin()));
}

void check_elements(const TextCursor& cursor, const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex" && !element.has_three(PlyRole::X))
            cursor.fail_at(element.line, "the vertices lack a coordinate", "properties x, y and z");
        const bool has_corners = element.name == "face" || element.name == "tristrips";
        if (has_corners && element.with(PlyRole::Indices) == nullptr)
            cursor.fail_at(element.line, fmt::format("the element \"{}\" has no corners", element.name),
                           "a property list vertex_indices");
    }
}

/// The first line end in `rest`; empty if there is none.
std::string line_end_of(std::string_view rest) {
    rest.remove_prefix(std::min(rest.find_first_of("\r\n"), rest.size()));
    const bool two = rest.starts_with("\r\n") || rest.starts_with("\n\r");
    return std::string(rest.substr(0, two ? 2 : 1));
}

/// Reads the lines between "ply" and "end_header".
class HeaderReader {
  public:
    explicit HeaderReader(TextCursor& cursor) : cursor_(cursor) {}

    PlyHeader read() {
        std::optional<PlyFormat> format;
        while (cursor_.next_line()) {
            const std::string_view keyword = cursor_.word();
            if (keyword == "end_header") {
                if (!format)
                    cursor_.fail("the header names no format", "a line such as \"format ascii 1.0\"");
                header_.format = *format;
                check_elements(cursor_, header_);
                return std::move(header_);
            }
            if (keyword == "comment" || keyword == "obj_info") {
                header_.textures += cursor_.word() == "TextureFile" ? 1 : 0;
                continue;
            }
            if (keyword == "format") {
                format = read_format(cursor_);
                const std::string_view version = cursor_.word();
                if (!version.empty() && version != "1.0")
                    cursor_.fail(fmt::format("{} is not a known PLY version", quoted_word(version)), "1.0");
            } else if (keyword == "element") {
                read_element();
            } else if (keyword == "property") {
                read_property();
            } else {
                cursor_.fail(fmt::format("{} is not a PLY header keyword", quoted_word(keyword)),
                             "format, element, property, comment, obj_info or end_header");
            }
        }
        cursor_.fail("the header does not end", "\"end_header\"");
    }

  private:
    /// Records the name of an element, or of a property of the last element; fails if it already exists.
    void take_name(std::set<std::string_view>& names, const char* kind, std::string_view name) {
        if (!names.insert(name).second)
            cursor_.fail(fmt::format("duplicate {} {}", kind, quoted_word(name)), "one");
        if (++name_count_ > max_ply_names)
            cursor_.fail("the header has too many elements and properties",
                         fmt::format("at most {}", max_ply_names));
    }

    void read_element() {
        PlyElement element;
        const std::string_view name = cursor_.word();
        element.name = name;
        element.line = cursor_.line();
        if (name.empty()) cursor_.fail("the element's name is missing", "\"element NAME COUNT\"");
        take_name(elements_, "element", name);
        const std::int64_t count = cursor_.integer("the element's count");
        if (count < 0 || count > static_cast<std::int64_t>(max_corners))
            cursor_.fail(fmt::format("a count of {} is out of range", count),
                         fmt::format("0 to {}", max_corners));
        element.count = static_cast<std::size_t>(count);
        header_.elements.push_back(std::move(element));
        properties_.clear();
    }

    void read_property() {
        if (header_.elements.empty())
            cursor_.fail("a property belongs to no element", "\"element\" before it");
        PlyElement& element = header_.elements.back();
        PlyProperty property;
        std::string_view type = cursor_.word();
        if (type == "list") {
            property.is_list = true;
            property.count_type = type_of(cursor_.word());
            if (!is_integer(property.count_type))
                cursor_.fail("a list's count is not a whole number", "an integer type");
            type = cursor_.word();
        }
        property.type = type_of(type);
        const std::string_view name = cursor_.word();
        if (name.empty()) cursor_.fail("the property's name is missing", "\"property TYPE NAME\"");
        take_name(properties_, "property", name);
        property.name = name;
        property.role = role_of(element.name, property);
        if (property.role == PlyRole::Indices && (!property.is_list || !is_integer(property.type)))
            cursor_.fail(fmt::format("{} is not a list of whole numbers", quoted_word(name)),
                         "a list of an integer type");
        element.add(std::move(property));
    }

    [[nodiscard]] PlyType type_of(std::string_view word) const {
        for (std::size_t i = 0; i < type_names.size(); ++i)
            if (word == type_names[i][0] || word == type_names[i][1]) return static_cast<PlyType>(i);
        cursor_.fail(word.empty() ? "the property's type is missing"
                                  : fmt::format("{} is not a type", quoted_word(word)),
                     "char, uchar, short, ushort, int, uint, float or double");
    }

    TextCursor& cursor_;
    PlyHeader header_;
    std::set<std::string_view> elements_, properties_;  // ordered, so no file can make them slow
    std::size_t name_count_ = 0;
};

/// Reads up to and including the word "end_header", in O(n log n) time for n names. Throws ProblemFound, or
/// LoadCancelled if this thread's load is cancelled.
PlyHeader read_ply_header(TextCursor& cursor) {
    if (!cursor.next_line() || cursor.word() != "ply")
        cursor.fail("this is not a PLY file", "\"ply\" as its first word");
    std::string line_end = line_end_of(cursor.rest());
    PlyHeader header = HeaderReader(cursor).read();
    header.line_end = std::move(line_end);
    return header;
}

// The rows of a .ply file's elements, value by value: as ASCII, or binary in either byte order.

/// Returns the offset to subtract from a coordinate.
double offset_of(const PlyHeader& header, PlyRole role) {
    return header.offset[static_cast<int>(role) - static_cast<int>(PlyRole::X)];
}

/// Reads the values of an ASCII body, which has one row per line.
class AsciiRows {
  public:
    AsciiRows(TextCursor& cursor, const PlyHeader& header, const std::string& /*file*/)
        : cursor_(cursor), header_(header) {}

    void begin_row(const PlyElement& element, std::size_t row) {
        if (!cursor_.next_line())
            cursor_.fail(fmt::format("the file ends after {} of element {}", row, quoted_word(element.name)),
                         fmt::format("{}", element.count));
    }
    void end_row() { cursor_.end_line("the header's properties only"); }
    float number(const PlyProperty& p) {
        if (is_normal(p.role)) return cursor_.normal_number(p.name);
        if (is_position(p.role)) return cursor_.number_minus(offset_of(header_, p.role), p.name);
        if (p.role != PlyRole::Other) return cursor_.number(p.name);
        if (cursor_.word().empty()) cursor_.fail(fmt::format("{} is missing", p.name), "a number");
        return 0;
    }
    std::int64_t integer(PlyType /*type*/, const PlyProperty& p) { return cursor_.integer(p.name); }
    void skip_list(const PlyProperty& p, std::int64_t count) {
        for (; count > 0; --count) static_cast<void>(number(p));
    }
    [[nodiscard]] std::size_t bytes_left() const { return cursor_.rest().size(); }
    [[nodiscard]] bool anything_left() { return cursor_.next_line(); }
    [[nodiscard]] int line() const { return cursor_.line(); }
    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        cursor_.fail(what, expected);
    }

  private:
    TextCursor& cursor_;
    const PlyHeader& header_;
};

/// Reads the values of a binary body, with the bytes of each value reversed if `swap`.
template <bool swap> class BinaryRows {
  public:
    BinaryRows(TextCursor& cursor, const PlyHeader& header, const std::string& file)
        : file_(file), header_(header), left_(cursor.rest()), bytes_(left_.size()), parsed_(bytes_) {
        // The first byte of the body may look like part of a line end, so the header's first line determines
        // the length of its line ends. A last line that ends differently ends with CR, LF or both.
        if (left_.starts_with(header.line_end)) {
            left_.remove_prefix(header.line_end.size());
            return;
        }
        if (left_.starts_with("\r")) left_.remove_prefix(1);
        if (left_.starts_with("\n")) left_.remove_prefix(1);
    }

    void begin_row(const PlyElement& element, std::size_t row) {
        element_ = &element;
        row_ = row;
    }
    void end_row() {}
    float number(const PlyProperty& p) {
        const double value = scalar(p.type);
        if (p.role != PlyRole::Other && !is_normal(p.role) && !(std::abs(value) <= max_number))
            fail(fmt::format("{} = {} is out of range", p.name, value), "-1e7 to 1e7");
        return static_cast<float>(is_position(p.role) ? value - offset_of(header_, p.role) : value);
    }
    std::int64_t integer(PlyType type, const PlyProperty& /*p*/) {
        return static_cast<std::int64_t>(scalar(type));
    }
    void skip_list(const PlyProperty& p, std::int64_t count) {
        take(static_cast<std::size_t>(count) * as_machine_type(p.type, [](auto of) { return sizeof(of); }));
    }
    [[nodiscard]] std::size_t bytes_left() const { return left_.size(); }
    [[nodiscard]] bool anything_left() const {
        return left_.find_first_not_of(" \t\r\n") != std::string_view::npos;
    }
    [[nodiscard]] int line() const { return 0; }
    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        throw ProblemFound({file_, "", fmt::format("{} {}: {}", element_->name, row_, what), expected, 0});
    }

  private:
    /// Calls visit() with a value of the corresponding C++ type.
    template <class Visit> static auto as_machine_type(PlyType type, const Visit& visit) {
        switch (type) {
        case PlyType::Int8:
            return visit(std::int8_t{});
        case PlyType::Uint8:
            return visit(std::uint8_t{});
        case PlyType::Int16:
            return visit(std::int16_t{});
        case PlyType::Uint16:
            return visit(std::uint16_t{});
        case PlyType::Int32:
            return visit(std::int32_t{});
        case PlyType::Uint32:
            return visit(std::uint32_t{});
        case PlyType::Float32:
            return visit(float{});
        case PlyType::Float64:
            break;
        }
        return visit(double{});
    }
    const char* take(std::size_t bytes) {
        parsed_.at(bytes_ - left_.size());
        if (bytes > left_.size()) fail("the file ends early", fmt::format("{} of them", element_->count));
        const char* at = left_.data();
        left_.remove_prefix(bytes);
        return at;
    }
    double scalar(PlyType type) {
        return as_machine_type(type, [this]<class T>(T) {
            std::array<char, sizeof(T)> bytes;
            std::memcpy(bytes.data(), take(sizeof(T)), sizeof(T));
            if constexpr (swap) std::reverse(bytes.begin(), bytes.end());
            return static_cast<double>(std::bit_cast<T>(bytes));
        });
    }

    const std::string& file_;
    const PlyHeader& header_;
    std::string_view left_;
    std::size_t bytes_;  // size of the entire body
    ParsedBytes parsed_;
    const PlyElement* element_ = nullptr;
    std::size_t row_ = 0;
};

/// The factor that scales colours to 0 .. 1: 1 for floats, else one over the largest number of the type. 0
/// without colours, and for types that no writer uses for colours.
float color_scale(const PlyElement& vertices) {
    if (!vertices.has_three(PlyRole::Red)) return 0;
    switch (vertices.with(PlyRole::Red)->type) {
    case PlyType::Uint8:
        return 1 / 255.f;
    case PlyType::Uint16:
        return 1 / 65535.f;
    case PlyType::Float32:
    case PlyType::Float64:
        return 1;
    default:
        return 0;
    }
}

template <class Rows> class PlyBody {
  public:
    PlyBody(const PlyHeader& header, TextCursor& cursor, const std::string& file)
        : header_(header), rows_(cursor, header, file), file_(file) {
        mesh_.first_corner.push_back(0);
        for (const PlyElement& element : header.elements)
            if (element.name == "vertex") vertex_count_ = element.count;
    }

    Mesh read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else if (element.name == "tristrips")
                read_strips(element);
            else
                skip(element);
        }
        warn(mesh_.warnings, header_.textures, "texture is not read", "textures are not read");
        if (rows_.anything_left()) mesh_.warnings.emplace_back("data after the last element is ignored");
        return std::move(mesh_);
    }

  private:
    void read_vertices(const PlyElement& element) {
        const bool normals = element.has_three(PlyRole::Nx);
        const float scale = color_scale(element);
        if (element.has_three(PlyRole::Red) && scale == 0)
            warn(mesh_.warnings, element.count,
                 "vertex has a colour of a signed or 32-bit type, which is ignored",
                 "vertices have colours of a signed or 32-bit type, which are ignored");
        if (element.has_part_of_three(PlyRole::Nx))
            warn(mesh_.warnings, element.count, "vertex has only part of a normal, which is ignored",
                 "vertices have only part of a normal, which is ignored");
        if (element.has_part_of_three(PlyRole::Red))
            warn(mesh_.warnings, element.count, "vertex has only part of a colour, which is ignored",
                 "vertices have only part of a colour, which is ignored");
        std::size_t beyond_type = 0;
        mesh_.positions.reserve(std::min(element.count, rows_.bytes_left() / 3));
        std::array<float, 11> value{};  // indexed by role
        const auto three = [&value](PlyRole first) {
            const auto i = static_cast<std::size_t>(first);
            return glm::vec3(value[i], value[i + 1], value[i + 2]);
        };
        const auto skip = [this](const PlyProperty& p) { skip_list(p); };
        const auto keep = [&value](const PlyProperty& p, float number) {
            value[static_cast<std::size_t>(p.role)] = number;
        };
        read_rows(element, skip, keep, [&] {
            mesh_.positions.push_back(three(PlyRole::X));
            if (normals) mesh_.normals.push_back(three(PlyRole::Nx));
            if (scale == 0) return;
            const glm::vec3 color = scale * three(PlyRole::Red);
            const bool beyond = scale < 1 && (color.r > 1 || color.g > 1 || color.b > 1);
            beyond_type += beyond ? 1 : 0;
            mesh_.colors.push_back(beyond ? glm::min(color, glm::vec3(1)) : color);
        });
        warn(mesh_.warnings, beyond_type,
             "vertex has a colour beyond the range of its type, which is clamped",
             "vertices have colours beyond the range of their type, which are clamped");
        if (normals) mesh_.given_normals = GivenNormals::File;
    }

    void read_faces(const PlyElement& element) {
        if (element.has_three(PlyRole::Red))
            warn(mesh_.warnings, element.count, "face has a colour, which is ignored",
                 "faces have colours, which are ignored");
        read_lists(element, [this](const PlyProperty& p) {
            if (p.role == PlyRole::Indices)
                read_corners(p);
            else
                skip_list(p);
        });
    }

    void read_corners(const PlyProperty& p) {
        for (std::int64_t count = list_count(p); count > 0; --count)
            mesh_.corner_position.push_back(vertex(rows_.integer(p.type, p)));
        close_face(mesh_, file_, rows_.line());
    }

    [[nodiscard]] std::uint32_t vertex(std::int64_t index) const {
        if (index < 0 || index >= static_cast<std::int64_t>(vertex_count_))
            rows_.fail(fmt::format("vertex index {} is out of range", index),
                       numbers_of(vertex_count_, "vertices"));
        return static_cast<std::uint32_t>(index);
    }

    void read_strips(const PlyElement& element) {
        read_lists(element, [this](const PlyProperty& p) {
            if (p.role == PlyRole::Indices)
                read_strip(p);
            else
                skip_list(p);
        });
    }

    /// Each vertex from the third on forms a triangle with the two before it; every second triangle has the
    /// opposite winding. -1 begins a new strip.
    void read_strip(const PlyProperty& p) {
        std::array<std::uint32_t, 2> last{};
        std::size_t length = 0;
        for (std::int64_t count = list_count(p); count > 0; --count) {
            const std::int64_t index = rows_.integer(p.type, p);
            if (index == -1 || index == std::int64_t{no_index}) {
                length = 0;
                continue;
            }
            const std::uint32_t v = vertex(index);
            if (length >= 2) {
                const std::size_t odd = length % 2;
                for (const std::uint32_t corner : {last[odd], last[1 - odd], v})
                    mesh_.corner_position.push_back(corner);
                close_face(mesh_, file_, rows_.line());
            }
            last = {last[1], v};
            ++length;
        }
    }

    std::int64_t list_count(const PlyProperty& p) {
        const std::int64_t count = rows_.integer(p.count_type, p);
        if (count < 0) rows_.fail(fmt::format("{} has {} entries", p.name, count), "0 or more");
        return count;
    }
    void skip_list(const PlyProperty& p) { rows_.skip_list(p, list_count(p)); }

    void skip(const PlyElement& element) {
        warn(mesh_.warnings, element.count,
             fmt::format("row of the element {} is not read", in_quotes(element.name)),
             fmt::format("rows of the element {} are not read", in_quotes(element.name)));
        if (element.properties.empty()) return;
        read_lists(element, [this](const PlyProperty& p) { skip_list(p); });
    }

    /// Reads all rows of the element: calls list(property) to read a list, keep(property, number) for each
    /// number, and end() after each row.
    template <class List, class Keep, class End>
    void read_rows(const PlyElement& element, const List& list, const Keep& keep, const End& end) {
        for (std::size_t row = 0; row < element.count; ++row) {
            rows_.begin_row(element, row);
            for (const PlyProperty& p : element.properties) {
                if (p.is_list)
                    list(p);
                else
                    keep(p, rows_.number(p));
            }
            rows_.end_row();
            end();
        }
    }
    /// Reads the lists of all rows, and skips single numbers.
    template <class List> void read_lists(const PlyElement& element, const List& list) {
        read_rows(
            element, list, [](const PlyProperty&, float) {}, [] {});
    }

    const PlyHeader& header_;
    Rows rows_;
    const std::string& file_;
    Mesh mesh_;
    std::size_t vertex_count_ = 0;
};

}  // namespace

Mesh read_ply(std::string_view bytes, const std::string& file, const glm::dvec3& offset) {
    TextCursor cursor(bytes, file, false);
    PlyHeader header = read_ply_header(cursor);
    header.offset = offset;
    constexpr bool big_machine = std::endian::native == std::endian::big;
    switch (header.format) {
    case PlyFormat::Ascii:
        return PlyBody<AsciiRows>(header, cursor, file).read();
    case PlyFormat::LittleEndian:
        return PlyBody<BinaryRows<big_machine>>(header, cursor, file).read();
    case PlyFormat::BigEndian:
        return PlyBody<BinaryRows<!big_machine>>(header, cursor, file).read();
    }
    return {};  // not reached
}

}  // namespace glint
