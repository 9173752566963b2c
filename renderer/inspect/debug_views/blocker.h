#pragma once
// What stands between a point and a light. The picture does not ask: illumination here is local, no object
// keeps light from another (lecture: "Local vs. Global Illumination"). This says where that shows.

#include <glm/vec3.hpp>
#include <optional>

#include "models/scene/scene.h"

namespace glint {

/// The index of an object of which a face lies on the way from `point` (world coordinates) towards `to_light`
/// (not zero), before the light, which is `distance` scene units away; 0: infinitely far. The object nearest
/// to the point; nothing when the way is free. Faces within a thousandth of their object's size of the point
/// do not count: it lies on one, and next to a coarse mesh's facets a smooth normal sees light that they
/// would block.
[[nodiscard]] std::optional<int> blocker(const Scene& scene, glm::dvec3 point, glm::dvec3 to_light,
                                         double distance);

}  // namespace glint
