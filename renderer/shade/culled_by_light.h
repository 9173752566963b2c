#pragma once
// The mistake of culling faces by the light instead of the eye (models/scene/mistakes.h).

#include <cstdint>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/geometry/geometry.h"

namespace glint {

/// Whether the lights also decide which face a pixel shows.
[[nodiscard]] inline bool lights_cull(const Scene& scene) { return scene.shading.mistakes.culled_by_light; }

/// For each triangle of the scene, 1 if its face has n.l <= 0 for the first enabled light at the face's
/// centroid (the mean of its corners), or has no area. Empty (nothing is culled) if the mistake is off or no
/// light is enabled. Precondition: `geometry` is up to date.
[[nodiscard]] std::vector<std::uint8_t> culled_by_light(const Scene& scene, const Geometry& geometry);

}  // namespace glint
