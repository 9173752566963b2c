#pragma once
// Explains the colour of a pixel: runs the functions that draw the picture again, with `float`, and records
// every step.

#include <vector>

#include "renderer/explain/explanation.h"
#include "renderer/stages.h"

namespace glint {

/// Precondition: the stages contain a drawn picture and (x, y) is inside it.
[[nodiscard]] Explanation explain_pixel(const KeptStages& stages, int x, int y);

/// Explains the pixel as if the scene were `other`. It may differ from the drawn scene in lights, materials,
/// ambient light, display and shading, but not in strokes or in anything that determines the visible face
/// (camera, meshes, transforms, `cull`). The result is bit-identical to drawing and explaining `other`, at
/// the cost of one pixel (plus all normals, if they differ).
[[nodiscard]] Explanation explain_pixel_as(KeptStages& stages, const Scene& other, int x, int y);

/// Implement Renderer::shadow_rays() and Renderer::bounce_path().
[[nodiscard]] std::vector<TracedLight> trace_lights(KeptStages& stages, int x, int y, int corner);
[[nodiscard]] std::vector<PathStep> trace_path(KeptStages& stages, int x, int y, int path, int corner);

}  // namespace glint
