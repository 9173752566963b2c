#pragma once
// A mistake in which faces are drawn (models/scene/mistakes.h): culling by the light in place of the eye.

#include <cstdint>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/geometry/geometry.h"

namespace glint {

/// Whether the lights, too, decide which face a pixel shows.
[[nodiscard]] inline bool lights_cull(const Scene& scene) { return scene.shading.mistakes.culled_by_light; }

/// For each triangle of the scene 1 where its face's normal has n.l <= 0 for the first enabled light, taken
/// at the face's centroid (the mean of its corners), as a face without an area has. Empty, so that none is
/// culled, without the mistake or without an enabled light. Precondition: `geometry` is up to date.
[[nodiscard]] std::vector<std::uint8_t> culled_by_light(const Scene& scene, const Geometry& geometry);

}  // namespace glint
