#pragma once
// Merges corners at exactly equal positions: for formats without indices, and for those that repeat a vertex
// for each of its normals. Inside models/ only.

#include <bit>
#include <chrono>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

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
