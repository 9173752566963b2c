// Stanford .ply: ASCII and binary of both byte orders, properties in any order and of any type.
// Source: G. Turk, "The PLY Polygon File Format", 1994.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <glm/common.hpp>

#include "models/mesh/formats/mesh_reader.h"
#include "models/mesh/formats/ply_header.h"
#include "models/mesh/formats/ply_rows.h"

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

}  // namespace glint
