#pragma once
// Finds what stands between a point and a light. The picture does not use it: illumination is local, and no
// object casts a shadow on another (lecture: "Local vs. Global Illumination"). This shows where that matters.

#include <glm/vec3.hpp>
#include <optional>

#include "models/scene/scene.h"

namespace glint {

/// Returns the index of the nearest object with a face between `point` (world coordinates) and a light in the
/// direction `to_light` (not zero), `distance` scene units away (0: infinitely far); nothing when the way is
/// free. Faces within a thousandth of their object's size of the point do not count: the point lies on one,
/// and next to the facets of a coarse mesh a smooth normal sees light that they would block.
[[nodiscard]] std::optional<int> blocker(const Scene& scene, glm::dvec3 point, glm::dvec3 to_light,
                                         double distance);

}  // namespace glint
