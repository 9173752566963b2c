#pragma once
// Shared parts of the mesh readers. Each reader converts the bytes of a file to an unfinished mesh (no
// triangles, no bounds) or throws ProblemFound. Inside models/ only.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "models/mesh/formats/text_cursor.h"
#include "models/mesh/mesh.h"
#include "models/problem.h"

namespace glint {

// `offset` is subtracted from positions in double, before they become floats.
[[nodiscard]] Mesh read_obj(std::string_view bytes, const std::string& file, const glm::dvec3& offset);
[[nodiscard]] Mesh read_ply(std::string_view bytes, const std::string& file, const glm::dvec3& offset);
[[nodiscard]] Mesh read_off(std::string_view bytes, const std::string& file, const glm::dvec3& offset);
[[nodiscard]] Mesh read_stl(std::string_view bytes, const std::string& file, const glm::dvec3& offset);

inline constexpr std::size_t max_corners = std::numeric_limits<std::int32_t>::max();

/// The number in `size` bytes, 1 to 8, lowest byte first. Precondition: the bytes exist.
inline std::uint64_t little_endian(const char* at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value |= std::uint64_t{static_cast<unsigned char>(at[i])} << (8 * i);
    return value;
}
/// The float in 4 bytes, lowest byte first. Precondition: the bytes exist.
inline float little_endian_float(const char* at) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(little_endian(at, 4)));
}

// Distinguish binary STL files from text: files of both kinds may begin with "solid". A text has no byte 0,
// and the header of a binary file has one, in its count of facets.

inline constexpr std::size_t binary_stl_header = 84, binary_stl_facet = 50;  // bytes
/// True when the first word is "solid", "SOLID" or "Solid" and no byte of the header is 0.
[[nodiscard]] bool begins_as_text_stl(std::string_view bytes);
/// Returns the number of facets in the header. Precondition: the header is complete.
[[nodiscard]] std::size_t binary_stl_facets(std::string_view bytes);
/// Returns the file size that this header implies; 0 if the header is incomplete.
[[nodiscard]] std::size_t binary_stl_size(std::string_view bytes);

/// The text after "expected": "0 to 7" for eight items; `things` if there are none.
[[nodiscard]] std::string numbers_of(std::size_t count, const char* things);

/// Replaces normals that are not finite, or longer than numbers may be, by (0, 0, 0), which counts as no
/// normal. Adds one warning.
void drop_bad_normals(Mesh& mesh);

/// Ends the polygon formed by the most recently appended corners.
void close_face(Mesh& mesh, const std::string& file, int line = 0);

}  // namespace glint
