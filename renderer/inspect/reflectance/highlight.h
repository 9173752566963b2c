#pragma once
// The highlight of one light at single points of a surface, and where a light must stand so that it peaks
// there: what dragging a highlight needs. The equation is the picture's own, mistakes and all.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/scene/camera.h"
#include "models/scene/scene.h"
#include "renderer/renderer.h"

namespace glint {

/// The specular term of `light` (whether it is one of the scene's or not, on or off) at each of `points`, for
/// a white light on a material with k_s = 1: the sum of the channels, falloff and cone included; of an area
/// light the sum of its samples. Each point is lit as such, as under the mode `phong`. >= 0; 0 where the
/// model has no highlight or the light is behind the surface.
[[nodiscard]] std::vector<double> highlight_at(const Scene& scene, PictureSize size, const Light& light,
                                               std::span<const SeenPoint> points);

/// n.l of a light at a point, not clamped; of an area light, of its middle sample (of four, the first).
[[nodiscard]] double cosine_at(const Scene& scene, PictureSize size, const Light& light,
                               const SeenPoint& point);

/// Unit direction from a point towards a light whose highlight has its largest factor there: v mirrored at
/// n, which is the same for (r.v)^n and (n.h)^n, and v itself for retro-reflection. Camera coordinates.
/// (0, 0, 0) where the surface turns away from the viewer (n.v <= 0).
[[nodiscard]] glm::vec3 peak_direction(const Scene& scene, PictureSize size, const SeenPoint& point);

}  // namespace glint
