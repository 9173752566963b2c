#pragma once
// The header of a .ply file: its elements and their properties. Inside models/ only.
// Source: G. Turk, "The PLY Polygon File Format", 1994.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "models/mesh/formats/text_cursor.h"

namespace glint {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
enum class PlyFormat { Ascii, LittleEndian, BigEndian };

/// The meaning of a property to our reader.
enum class PlyRole { Other, X, Y, Z, Nx, Ny, Nz, Red, Green, Blue, Indices };
inline constexpr std::size_t ply_role_count = 11;
constexpr bool is_position(PlyRole role) { return role >= PlyRole::X && role <= PlyRole::Z; }
constexpr bool is_normal(PlyRole role) { return role >= PlyRole::Nx && role <= PlyRole::Nz; }

/// The limit of elements and properties in a header, counted together. Real files have a few dozen.
inline constexpr std::size_t max_ply_names = 65536;

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool is_list = false;
    PlyType count_type = PlyType::Uint8;  // lists only
    PlyRole role = PlyRole::Other;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
    int line = 0;

    void add(PlyProperty property);
    /// The first property of that role; null if there is none. Precondition: the role is not Other.
    [[nodiscard]] const PlyProperty* with(PlyRole role) const;
    /// True if all three roles that begin with `first` exist, as single values.
    [[nodiscard]] bool has_three(PlyRole first) const;
    /// True if only one or two of the three exist.
    [[nodiscard]] bool has_part_of_three(PlyRole first) const;

  private:
    [[nodiscard]] int count_of_three(PlyRole first) const;

    std::array<std::size_t, ply_role_count> number_of_{};  // 1 + the index of the role's property; 0: none
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::string line_end;      // of the first line: LF, CR, CR LF or LF CR
    std::size_t textures = 0;  // named in comments, as MeshLab does
    glm::dvec3 offset{0};      // set by the reader; subtracted from positions
};

/// Reads up to and including the word "end_header", in time n log n for n names. Throws ProblemFound;
/// LoadCancelled when this thread's load is cancelled.
[[nodiscard]] PlyHeader read_ply_header(TextCursor& cursor);

// The rows of a .ply file's elements, value by value: as ASCII, or binary in either byte order. Inside
// models/ only.

/// The offset to subtract from a coordinate.
inline double offset_of(const PlyHeader& header, PlyRole role) {
    return header.offset[static_cast<int>(role) - static_cast<int>(PlyRole::X)];
}

/// Values of an ASCII body: one row per line.
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
    std::size_t bytes_;  // of the entire body
    ParsedBytes parsed_;
    const PlyElement* element_ = nullptr;
    std::size_t row_ = 0;
};

}  // namespace glint
