#pragma once
// Positions so far away that the square of their distance does not fit a float.

#include <algorithm>
#include <glm/geometric.hpp>

#include "renderer/geometry/outside_bits.h"

namespace glint {

/// How many times nearer `place` (camera coordinates) has to be for its distance to be `max_distance`; 1
/// when it is not farther.
[[nodiscard]] inline double share_of_way(const glm::dvec3& place) {
    return std::min(1.0, max_distance / glm::length(place));
}
/// The place, or the one in the same direction that is not too far.
[[nodiscard]] inline glm::dvec3 not_too_far(const glm::dvec3& place) { return share_of_way(place) * place; }

}  // namespace glint
