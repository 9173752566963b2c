#pragma once
// Converts the scene's lights to what the kernels take: camera coordinates, colours times intensity. Lecture:
// "Light Sources": standard: world coordinates; alternative: camera coordinates (car headlights).

#include <glm/mat4x4.hpp>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"

namespace glint {

/// The enabled lights in the scene's order; an area light gives one source a sample.
[[nodiscard]] std::vector<LightSource> light_sources(const Scene& scene);

/// Puts the enabled lights into `sources`, reusing its memory.
void light_sources(const Scene& scene, std::vector<LightSource>& sources);

/// Camera coordinates from a light's own: the view matrix for a light given in world coordinates, and the
/// identity for one given in camera coordinates; mistakes may replace it.
[[nodiscard]] glm::dmat4 camera_from_light(LightSpace space, const glm::dmat4& view_from_world,
                                           const Mistakes& mistakes = {});

/// What every light's share is divided by: 1, but for the mistake of averaging, where it is the number of
/// enabled lights, at least 1.
[[nodiscard]] double share_divisor(const Scene& scene);

/// One object's part of the equation. `lights` must outlive the job. `at_corners`: the colours will be
/// blended over faces, which OpenGL's rules clamp before.
[[nodiscard]] LightJob light_job(const Scene& scene, PictureSize size, const Material& material,
                                 const std::vector<LightSource>& lights, bool at_corners);

}  // namespace glint
