#pragma once
// Finds the highlight under the cursor. Dragging its rim makes it larger or smaller: the exponent, or the
// roughness, follows so that the rim stays under the cursor. The rim is where the highlight is half of the
// most that it could be there.

#include <optional>

#include "models/scene/light.h"
#include "models/scene/material.h"
#include "ui/picture/surface_patch.h"

namespace glint {

/// Returns the highlight of a light at a point of a surface with that material, relative to what it would be
/// if the light stood where its factor is largest there: (r.v)^n for Phong. 0 where the surface turns away
/// from the viewer or there is no highlight; noise may bring it a little above 1.
[[nodiscard]] double highlight_share(const SurfaceView& view, const Light& light, const SeenPoint& point,
                                     const Material& material);

/// A light whose highlight shows at a pixel.
struct HoveredHighlight {
    int light = -1;
    double share = 0;  // of the most that the highlight could be there, above 0
};

/// Returns the light whose highlight covers the pixel: it must be visible (more than 0.15 of full brightness)
/// and near its peak there (at least half of it). The brightest wins. Nothing on the background, without the
/// specular term, or under models without a highlight.
[[nodiscard]] std::optional<HoveredHighlight> highlight_under(const SurfaceView& view, glm::dvec2 pixel);

/// Returns the light whose highlight has its rim within `reach` pixels; inside a small highlight within less,
/// so that its middle can be grabbed too. Nothing on the background, without the specular term, or under
/// models without a highlight.
[[nodiscard]] std::optional<int> highlight_rim_under(const SurfaceView& view, glm::dvec2 pixel, double reach);

struct SizeDrag {
    Light light;
    int object = 0;  // whose material it is
    Material start;
};

/// Returns the material with which the rim lies under `pixel`, or as near as its range allows. Nothing on the
/// background, on other objects, or if the light has no highlight whatever the material.
[[nodiscard]] std::optional<Material> sized_highlight(const SizeDrag& drag, const SurfaceView& view,
                                                      glm::dvec2 pixel);

}  // namespace glint
