#pragma once
// What the readers of the mesh formats share. Each turns the bytes of a whole file into an unfinished mesh
// (no triangles, no bounds) or throws Unreadable. Inside models/ only.

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "models/io/text_cursor.h"
#include "models/mesh/mesh.h"
#include "models/problem.h"
#include "models/warn.h"

namespace glint {

[[nodiscard]] Mesh read_obj(std::string_view bytes, const std::string& file);
[[nodiscard]] Mesh read_ply(std::string_view bytes, const std::string& file);
[[nodiscard]] Mesh read_off(std::string_view bytes, const std::string& file);
[[nodiscard]] Mesh read_stl(std::string_view bytes, const std::string& file);
[[nodiscard]] Mesh read_om(std::string_view bytes, const std::string& file);

inline constexpr std::size_t most_corners = std::numeric_limits<std::int32_t>::max();

/// Throws Refused when what the mesh holds so far does not fit in the memory that there is for it.
void require_room(const Mesh& mesh);
/// After each vertex: now and then the above.
inline void vertex_read(const Mesh& mesh) {
    constexpr std::size_t vertices_between = 1 << 16;
    if (mesh.positions.size() % vertices_between == 0) require_room(mesh);
}

/// The number in `size` bytes, 1 to 8, the lowest first. Precondition: they are there.
inline std::uint64_t little_endian(const char* at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value |= std::uint64_t{static_cast<unsigned char>(at[i])} << (8 * i);
    return value;
}
/// The float in 4 bytes, the lowest first. Precondition: they are there.
inline float little_endian_float(const char* at) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(little_endian(at, 4)));
}

/// Ends the polygon that the corners appended last make up.
void close_face(Mesh& mesh, const std::string& file, int line = 0);

}  // namespace glint
