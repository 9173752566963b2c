#pragma once
// Shared parts of the mesh readers. Each reader converts the bytes of a file to an unfinished mesh (no
// triangles, no bounds) or throws ProblemFound. Inside models/ only.

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdint>
#include <glm/vec3.hpp>
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

// Merges corners at exactly equal positions: for formats without indices, and for those that repeat a vertex
// for each of its normals. Inside models/ only.

/// Sets Mesh::first_at_place.
void find_places(Mesh& mesh);

/// Numbers positions in the order of their first use, with an open-addressing hash table of indices. The hash
/// is seeded with the time, so that no file can make it slow; the numbers do not depend on the seed.
class Places {
  public:
    /// `expected`: the number of positions, if it is known.
    explicit Places(std::size_t expected = 0) {
        if (expected > 0) slots_.assign(std::bit_ceil(2 * (expected + 1)), no_index);
    }
    std::uint32_t index_of(glm::vec3 place, std::vector<glm::vec3>& positions) {
        place += glm::vec3(0);  // -0 is 0
        if (2 * (positions.size() + 1) > slots_.size()) grow(positions);
        std::size_t slot = hash(place) & (slots_.size() - 1);
        for (; slots_[slot] != no_index; slot = (slot + 1) & (slots_.size() - 1))
            if (positions[slots_[slot]] == place) return slots_[slot];
        slots_[slot] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(place);
        return slots_[slot];
    }

  private:
    [[nodiscard]] std::size_t hash(const glm::vec3& place) const {
        std::uint64_t h = seed_;
        for (int i = 0; i < 3; ++i) {  // one step of splitmix64
            h = (h ^ std::bit_cast<std::uint32_t>(place[i])) * 0xBF58476D1CE4E5B9u;
            h = (h ^ h >> 29) * 0x94D049BB133111EBu;
            h ^= h >> 32;
        }
        return static_cast<std::size_t>(h);
    }
    void grow(const std::vector<glm::vec3>& positions) {
        const std::size_t size = std::max<std::size_t>(64, 2 * slots_.size());
        slots_.assign(size, no_index);
        for (std::uint32_t i = 0; i < positions.size(); ++i) {
            std::size_t slot = hash(positions[i]) & (slots_.size() - 1);
            while (slots_[slot] != no_index) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = i;
        }
    }

    std::vector<std::uint32_t> slots_;  // size: a power of two
    std::uint64_t seed_ =
        static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
};

}  // namespace glint
