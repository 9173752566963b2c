#pragma once
// Curves of one factor of the equation over its argument, for plots, sampled from the equation's own
// functions. Lecture: "Light Source Falloff", "Light Sources" (spot), "Phong Lighting Model" (cos^n).

#include <glm/vec2.hpp>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// (r, falloff) from 0 to `farthest` (> 0) scene units, `steps` (>= 1) steps; empty for a light whose falloff
/// is not a function of r alone (directional: none; area: one per sample). Precondition: `light` is an index
/// of Scene::lights; it may be off.
[[nodiscard]] std::vector<glm::dvec2> falloff_curve(const Scene& scene, int light, double farthest,
                                                    int steps);

/// (degrees from the spot's axis, factor) from -90 to 90; empty for a light without a cone. The samples
/// include the cutoff's two edges and the angles just beyond them.
[[nodiscard]] std::vector<glm::dvec2> spot_curve(const Scene& scene, int light, int steps);

/// (degrees between r and v, S) from -90 to 90 under a light at the normal: cos^n for Phong, cos^n of half
/// the angle for Blinn-Phong. For other reflection models, the curve of their S.
[[nodiscard]] std::vector<glm::dvec2> highlight_curve(Reflection reflection, float shininess, int steps);

/// S of a surface with k_s = 1 in the direction `view_deg` from its normal, under a light at the normal.
[[nodiscard]] double highlight_at(Reflection reflection, float shininess, double view_deg);

}  // namespace glint
