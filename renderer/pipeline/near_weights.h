#pragma once
// Interpolation that is linear on the screen needs corners that are on the screen. A triangle cut by the near plane
// is therefore clipped first; its new corners get perspective-correct values (docs/interface.md, "interpolation").

#include "renderer/lighting/vec3.h"
#include "renderer/pipeline/surface.h"

namespace glint {

/// True when the near plane cuts the triangle (it is visible, so not all of it lies behind).
[[nodiscard]] bool near_is_crossed(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c);

/// Weights of the three original corners at pixel (x, y) of what the clipped polygon, split as a fan, interpolates
/// linearly on the screen.
[[nodiscard]] Vec3<float> near_clipped_screen_weights(const Geometry& geometry, const SampleFace& face, int x, int y);

}  // namespace glint
