#pragma once
// Converts the scene's lights to the input of the kernels: camera coordinates, colours times intensity.
// Lecture: "Light Sources" (world coordinates by default, or camera coordinates, as for car headlights).

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/geometry/geometry.h"
#include "renderer/lighting/light_job.h"

namespace glint {

/// The enabled lights in scene order. An area light gives one source per sample.
[[nodiscard]] std::vector<LightSource> light_sources(const Scene& scene);

/// Stores the enabled lights in `sources`, reusing its memory.
void light_sources(const Scene& scene, std::vector<LightSource>& sources);

/// The transform of a light to camera coordinates: the view matrix for a light in world coordinates, the
/// identity for one in camera coordinates. Mistakes may replace it.
[[nodiscard]] glm::dmat4 camera_from_light(LightSpace space, const glm::dmat4& view_from_world,
                                           const Mistakes& mistakes = {});

/// The divisor of every light's contribution: 1, or with the averaging mistake, the number of enabled lights,
/// at least 1.
[[nodiscard]] double share_divisor(const Scene& scene);

/// The input of the equation for one object. `lights` must outlive the job. `at_corners`: the colours will be
/// blended over faces; under OpenGL's rules they are clamped first.
[[nodiscard]] LightJob light_job(const Scene& scene, PictureSize size, const Material& material,
                                 const std::vector<LightSource>& lights, bool at_corners);

// The mistake of culling faces that face away from the light, not from the eye (models/scene/mistakes.h).

/// Whether the lights also decide which face a pixel shows.
[[nodiscard]] inline bool lights_cull(const Scene& scene) { return scene.shading.mistakes.culled_by_light; }

/// For each triangle of the scene, 1 if its face has n.l <= 0 for the first enabled light at the face's
/// centroid (the mean of its corners), or has no area. Empty (nothing is culled) if the mistake is off or no
/// light is enabled. Precondition: `geometry` is up to date.
[[nodiscard]] std::vector<std::uint8_t> culled_by_light(const Scene& scene, const Geometry& geometry);

}  // namespace glint
