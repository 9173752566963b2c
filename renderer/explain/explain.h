#pragma once
// Explains why a pixel has its colour: runs the picture's own functions again with `float` and keeps every
// step.

#include "renderer/explain/explanation.h"
#include "renderer/stages.h"

namespace glint {

/// Precondition: the stages hold a drawn picture and (x, y) is inside it.
[[nodiscard]] Explanation explain_pixel(const KeptStages& stages, int x, int y);

/// Explains the pixel as if the scene were `other`, which may differ from the drawn one in lights,
/// materials, ambient light, display and shading, but in nothing that decides which face a pixel shows
/// (camera, meshes, transforms, `cull`) nor in strokes. As if `other` were drawn and explained, to the last
/// bit, at the cost of one pixel (of all normals, when they differ).
[[nodiscard]] Explanation explain_pixel_as(const KeptStages& stages, const Scene& other, int x, int y);

}  // namespace glint
