#pragma once
// Finds the highlight under the cursor. Dragging its rim resizes it: the exponent, or the roughness, is
// solved so that the rim stays under the cursor. At the rim the highlight is half of its maximum possible
// value there.

#include <optional>

#include "models/scene/light.h"
#include "models/scene/material.h"
#include "ui/picture/surface_patch.h"

namespace glint {

/// Returns the highlight of a light at a point of a surface with that material, relative to its maximum over
/// all light directions there: (r.v)^n for Phong. 0 where the surface faces away from the viewer or there is
/// no highlight; noise may raise it slightly above 1.
[[nodiscard]] double highlight_share(const SurfaceView& view, const Light& light, const SeenPoint& point,
                                     const Material& material);

/// A light whose highlight is visible at a pixel.
struct HoveredHighlight {
    int light = -1;
    double share = 0;  // share of the highlight's possible maximum there, above 0
};

/// Returns the light whose highlight covers the pixel: it must be visible (more than 0.15 of full brightness)
/// and near its peak there (at least half of it). The brightest wins. Nothing on the background, without the
/// specular term, or under models without a highlight.
[[nodiscard]] std::optional<HoveredHighlight> highlight_under(const SurfaceView& view, glm::dvec2 pixel);

/// Returns the light whose highlight has its rim within `reach` pixels; less inside a small highlight, so
/// that its centre can be grabbed too. Nothing on the background, without the specular term, or under models
/// without a highlight.
[[nodiscard]] std::optional<int> highlight_rim_under(const SurfaceView& view, glm::dvec2 pixel, double reach);

struct SizeDrag {
    Light light;
    int object = 0;  // index of the object with the material
    Material start;
};

/// Returns the material that puts the rim under `pixel`, or as near as its range allows. Nothing on the
/// background, on other objects, or if the light has no highlight with any material.
[[nodiscard]] std::optional<Material> sized_highlight(const SizeDrag& drag, const SurfaceView& view,
                                                      glm::dvec2 pixel);

}  // namespace glint
