// Stanford .ply: ASCII and binary of both byte orders, properties in any order and of any type.
// Source: G. Turk, "The PLY Polygon File Format", 1994.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <glm/common.hpp>
#include <optional>
#include <set>
#include <string_view>

#include "models/mesh/formats/mesh_reader.h"
#include "models/mesh/formats/ply_header.h"

namespace glint {
namespace {

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
            warn(mesh_.warnings, element.count, "vertex has a part of a normal only, which is ignored",
                 "vertices have a part of a normal only, which is ignored");
        if (element.has_part_of_three(PlyRole::Red))
            warn(mesh_.warnings, element.count, "vertex has a part of a colour only, which is ignored",
                 "vertices have a part of a colour only, which is ignored");
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
             "vertex has a colour beyond its type, which is taken as the largest",
             "vertices have colours beyond their type, which are taken as the largest");
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

    /// Each vertex from the third on is a triangle with the two before it; every second triangle has the
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

namespace {

/// Both names of each PlyType, in its order.
constexpr std::array<std::array<std::string_view, 2>, 8> type_names{{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
/// The names of a vertex's properties, in the order of PlyRole from X on.
constexpr std::array<std::string_view, 9> vertex_roles{"x",  "y",   "z",     "nx",  "ny",
                                                       "nz", "red", "green", "blue"};

PlyFormat read_format(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    if (word == "ascii") return PlyFormat::Ascii;
    if (word == "binary_little_endian") return PlyFormat::LittleEndian;
    if (word == "binary_big_endian") return PlyFormat::BigEndian;
    cursor.fail(fmt::format("{} is not a format of a PLY file", quoted_word(word)),
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
                    cursor_.fail(
                        fmt::format("{} is not a version of PLY that is known", quoted_word(version)), "1.0");
            } else if (keyword == "element") {
                read_element();
            } else if (keyword == "property") {
                read_property();
            } else {
                cursor_.fail(fmt::format("{} is not a keyword of a PLY header", quoted_word(keyword)),
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
    std::set<std::string_view> elements_, properties_;  // ordered: no file can make them slow
    std::size_t name_count_ = 0;
};

}  // namespace

void PlyElement::add(PlyProperty property) {
    std::size_t& number = number_of_[static_cast<std::size_t>(property.role)];
    properties.push_back(std::move(property));
    if (number == 0) number = properties.size();
}

const PlyProperty* PlyElement::with(PlyRole role) const {
    const std::size_t number = number_of_[static_cast<std::size_t>(role)];
    return number == 0 ? nullptr : &properties[number - 1];
}

int PlyElement::count_of_three(PlyRole first) const {
    int there = 0;
    for (int i = 0; i < 3; ++i)
        there += with(static_cast<PlyRole>(static_cast<int>(first) + i)) != nullptr ? 1 : 0;
    return there;
}
bool PlyElement::has_three(PlyRole first) const { return count_of_three(first) == 3; }
bool PlyElement::has_part_of_three(PlyRole first) const {
    return count_of_three(first) > 0 && !has_three(first);
}

PlyHeader read_ply_header(TextCursor& cursor) {
    if (!cursor.next_line() || cursor.word() != "ply")
        cursor.fail("this is not a PLY file", "\"ply\" as its first word");
    std::string line_end = line_end_of(cursor.rest());
    PlyHeader header = HeaderReader(cursor).read();
    header.line_end = std::move(line_end);
    return header;
}

}  // namespace glint
