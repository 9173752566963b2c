#pragma once
// The header of a .ply file: its elements and their properties. Inside models/ only.
// Source: G. Turk, "The PLY Polygon File Format", 1994.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
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

}  // namespace glint
