#include "models/ply_header.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "models/mesh_reader.h"

namespace glint {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{{{"char", PlyType::Int8},
                                                                           {"int8", PlyType::Int8},
                                                                           {"uchar", PlyType::Uint8},
                                                                           {"uint8", PlyType::Uint8},
                                                                           {"short", PlyType::Int16},
                                                                           {"int16", PlyType::Int16},
                                                                           {"ushort", PlyType::Uint16},
                                                                           {"uint16", PlyType::Uint16},
                                                                           {"int", PlyType::Int32},
                                                                           {"int32", PlyType::Int32},
                                                                           {"uint", PlyType::Uint32},
                                                                           {"uint32", PlyType::Uint32},
                                                                           {"float", PlyType::Float32},
                                                                           {"float32", PlyType::Float32},
                                                                           {"double", PlyType::Float64},
                                                                           {"float64", PlyType::Float64}}};

PlyType read_type(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    for (const auto& [name, type] : type_names)
        if (name == word) return type;
    cursor.fail(
        word.empty() ? "the property's type is missing" : fmt::format("{} is no type", quoted_word(word)),
        "char, uchar, short, ushort, int, uint, float or double");
}

PlyFormat read_format(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    if (word == "ascii") return PlyFormat::Ascii;
    if (word == "binary_little_endian") return PlyFormat::LittleEndian;
    if (word == "binary_big_endian") return PlyFormat::BigEndian;
    cursor.fail(fmt::format("{} is no format of a PLY file", quoted_word(word)),
                "ascii, binary_little_endian or binary_big_endian");
}

PlyRole role_of(std::string_view element, const PlyProperty& property) {
    constexpr std::array<std::pair<std::string_view, PlyRole>, 9> vertex_roles{{{"x", PlyRole::X},
                                                                                {"y", PlyRole::Y},
                                                                                {"z", PlyRole::Z},
                                                                                {"nx", PlyRole::Nx},
                                                                                {"ny", PlyRole::Ny},
                                                                                {"nz", PlyRole::Nz},
                                                                                {"red", PlyRole::Red},
                                                                                {"green", PlyRole::Green},
                                                                                {"blue", PlyRole::Blue}}};
    if (element == "face" && (property.name == "vertex_indices" || property.name == "vertex_index"))
        return PlyRole::Indices;
    if (element != "vertex" && element != "face") return PlyRole::Other;
    for (const auto& [name, role] : vertex_roles)
        if (name == property.name && !property.is_list) return role;
    return PlyRole::Other;
}

PlyElement read_element(TextCursor& cursor, const PlyHeader& header) {
    PlyElement element;
    element.name = cursor.word();
    element.line = cursor.line();
    if (element.name.empty()) cursor.fail("the element's name is missing", "\"element NAME COUNT\"");
    for (const PlyElement& other : header.elements)
        if (other.name == element.name)
            cursor.fail(fmt::format("element {} comes twice", quoted_word(element.name)), "one");
    const std::int64_t count = cursor.integer("the element's count");
    if (count < 0 || count > static_cast<std::int64_t>(most_corners))
        cursor.fail(fmt::format("a count of {} is out of range", count),
                    fmt::format("0 to {}", most_corners));
    element.count = static_cast<std::size_t>(count);
    return element;
}

void read_property(TextCursor& cursor, PlyHeader& header) {
    if (header.elements.empty()) cursor.fail("a property belongs to no element", "\"element\" before it");
    PlyElement& element = header.elements.back();
    PlyProperty property;
    TextCursor ahead = cursor;
    if (ahead.word() == "list") {
        cursor = ahead;
        property.is_list = true;
        property.count_type = read_type(cursor);
        if (!is_integer(property.count_type))
            cursor.fail("a list's count is no whole number", "an integer type");
    }
    property.type = read_type(cursor);
    property.name = cursor.word();
    if (property.name.empty()) cursor.fail("the property's name is missing", "\"property TYPE NAME\"");
    for (const PlyProperty& other : element.properties)
        if (other.name == property.name)
            cursor.fail(fmt::format("property {} comes twice", quoted_word(property.name)), "one");
    property.role = role_of(element.name, property);
    if (property.role == PlyRole::Indices && (!property.is_list || !is_integer(property.type)))
        cursor.fail(fmt::format("{} is no list of whole numbers", quoted_word(property.name)),
                    "a list of an integer type");
    element.properties.push_back(std::move(property));
}

void check_elements(const TextCursor& cursor, const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex" && !element.has_three(PlyRole::X))
            cursor.fail_at(element.line, "the vertices lack a coordinate", "properties x, y and z");
        if (element.name == "face" && element.with(PlyRole::Indices) == nullptr)
            cursor.fail_at(element.line, "the faces have no corners", "a property list vertex_indices");
    }
}

}  // namespace

bool is_integer(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

const PlyProperty* PlyElement::with(PlyRole role) const {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [role](const PlyProperty& p) { return p.role == role; });
    return found == properties.end() ? nullptr : &*found;
}

bool PlyElement::has_three(PlyRole first) const {
    const int role = static_cast<int>(first);
    return with(first) != nullptr && with(static_cast<PlyRole>(role + 1)) != nullptr &&
           with(static_cast<PlyRole>(role + 2)) != nullptr;
}

PlyHeader read_ply_header(TextCursor& cursor) {
    if (!cursor.next_line() || cursor.word() != "ply")
        cursor.fail("this is no PLY file", "\"ply\" as its first word");
    PlyHeader header;
    std::optional<PlyFormat> format;
    while (cursor.next_line()) {
        const std::string_view keyword = cursor.word();
        if (keyword == "end_header") {
            if (!format) cursor.fail("the header names no format", "\"format ascii 1.0\", say");
            header.format = *format;
            check_elements(cursor, header);
            return header;
        }
        if (keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "format") {
            format = read_format(cursor);
        } else if (keyword == "element") {
            header.elements.push_back(read_element(cursor, header));
        } else if (keyword == "property") {
            read_property(cursor, header);
        } else {
            cursor.fail(fmt::format("{} is no keyword of a PLY header", quoted_word(keyword)),
                        "format, element, property, comment, obj_info or end_header");
        }
    }
    cursor.fail("the header does not end", "\"end_header\"");
}

}  // namespace glint
