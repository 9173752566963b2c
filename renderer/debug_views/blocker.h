#pragma once
// Finds the object that blocks the light at a point. The picture ignores blockers: illumination is local, and
// no object casts a shadow on another (lecture: "Local vs. Global Illumination"). This shows where that
// matters.

#include <glm/vec3.hpp>
#include <optional>

#include "models/scene/scene.h"

namespace glint {

/// Returns the index of the nearest object with a face between `point` (world coordinates) and a light in the
/// direction `to_light` (not zero), `distance` scene units away (0: infinitely far); nothing if the light is
/// visible. Ignores faces within a thousandth of their object's size of the point: the point is on one of
/// them, and on a coarse mesh its neighbours would block light that the smooth normal receives.
[[nodiscard]] std::optional<int> blocker(const Scene& scene, glm::dvec3 point, glm::dvec3 to_light,
                                         double distance);

}  // namespace glint
