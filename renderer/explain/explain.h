#pragma once
// Explains the colour of a pixel: reruns the picture's own functions with `float` and keeps every step.

#include <vector>

#include "renderer/explain/explanation.h"
#include "renderer/stages.h"

namespace glint {

/// Precondition: the stages contain a drawn picture and (x, y) is inside it.
[[nodiscard]] Explanation explain_pixel(const KeptStages& stages, int x, int y);

/// Explains the pixel as if the scene were `other`, which may differ from the drawn one in lights,
/// materials, ambient light, display and shading, but not in strokes or in anything that decides which face a
/// pixel shows (camera, meshes, transforms, `cull`). Gives the same bits as drawing and explaining `other`,
/// at the cost of one pixel (of all normals, if they differ).
[[nodiscard]] Explanation explain_pixel_as(KeptStages& stages, const Scene& other, int x, int y);

/// Renderer::shadow_rays() and Renderer::bounce_path().
[[nodiscard]] std::vector<TracedLight> trace_lights(KeptStages& stages, int x, int y, int corner);
[[nodiscard]] std::vector<PathStep> trace_path(KeptStages& stages, int x, int y, int path, int corner);

}  // namespace glint
