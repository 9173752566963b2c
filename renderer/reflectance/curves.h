#pragma once
// Plots single factors of the equation over their argument, sampled from the equation's own functions.
// Lecture: "Light Source Falloff", "Light Sources" (spot), "Phong Lighting Model" (cos^n).

#include <glm/vec2.hpp>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// (r, falloff) from 0 to `farthest` (> 0) scene units in `steps` (>= 1) steps. Empty if the light's falloff
/// is not a function of r alone (directional: no falloff; area: one falloff per sample). Precondition:
/// `light` is an index into Scene::lights. The light may be disabled.
[[nodiscard]] std::vector<glm::dvec2> falloff_curve(const Scene& scene, int light, double farthest,
                                                    int steps);

/// (degrees from the spot's axis, factor) from -90 to 90. Empty for a light without a cone. The samples
/// include both edges of the cutoff and the angles just outside them.
[[nodiscard]] std::vector<glm::dvec2> spot_curve(const Scene& scene, int light, int steps);

/// (degrees between r and v, S) from -90 to 90 for a light at the normal: cos^n for Phong, cos^n of half the
/// angle for Blinn-Phong. For other reflection models, their S.
[[nodiscard]] std::vector<glm::dvec2> highlight_curve(Reflection reflection, float shininess, int steps);

/// S of a surface with k_s = 1 at `view_deg` from its normal, for a light at the normal.
[[nodiscard]] double highlight_at(Reflection reflection, float shininess, double view_deg);

}  // namespace glint
