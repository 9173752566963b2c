#pragma once
// Dragging a highlight moves the light so that its specular term peaks under the cursor. The light keeps its
// distance from the surface (a directional light stays on its dome); a spot or a panel turns as it moves.
//
// The direction in which (r.v)^n or (n.h)^n is largest is known: l is v mirrored about n. But falloff, a
// cone, the samples of a panel and the angles of microfacets shift the peak in the picture away from there,
// more so for dull surfaces. So the search begins at the mirror direction and drives the slope of the
// specular term over the pixels around the cursor to zero.

#include <optional>
#include <vector>

#include "models/scene/scene.h"
#include "ui/picture/draw_picture.h"

namespace glint {

struct HighlightDrag {
    Light start;
    glm::dvec3 grabbed{0};  // the grabbed point on the surface, world
    double distance = 1;    // distance of the light from that point
    double nearer = 1;      // the factor that dragging in depth applies to the distance
    // During a drag in depth: the pixel where the highlight stays. After one: its offset from the cursor.
    std::optional<glm::dvec2> stays_at;
    glm::dvec2 beside{0};
};

/// Grabs a light by its effect at a point.
[[nodiscard]] HighlightDrag grab_highlight(const SurfaceView& view, const Light& light,
                                           const SeenPoint& point);
/// Grabs a light by its effect at a pixel; returns nullopt on the background.
[[nodiscard]] std::optional<HighlightDrag> grab_highlight(const SurfaceView& view, const Light& light,
                                                          glm::dvec2 pixel);

/// Returns the light with its highlight's peak at `pixel`, drag.nearer times as far away as when grabbed.
/// Returns nullopt if that is impossible: on the background, or where the surface faces away from the viewer.
[[nodiscard]] std::optional<Light> dragged_highlight(const HighlightDrag& drag, const SurfaceView& view,
                                                     glm::dvec2 pixel);

/// Applies one movement of the cursor. The highlight follows it. During a drag in depth, the highlight stays,
/// and the light moves away as the cursor moves up, by a factor of e per third of the picture (a directional
/// light has no distance). Returns the light, or nullopt as above.
[[nodiscard]] std::optional<Light> moved_highlight(HighlightDrag& drag, const SurfaceView& view,
                                                   glm::dvec2 cursor_px, glm::dvec2 last_px, bool in_depth);

/// Returns the light moved in the direction `away` (a unit vector in the world) from `place`. A spot or a
/// panel turns so that `place` is lit as the grabbed point was.
[[nodiscard]] Light carried(const HighlightDrag& drag, const SurfaceView& view, glm::dvec3 place,
                            glm::dvec3 away, double nearer = 1);

// Finds the highlight under the cursor. Dragging its rim resizes it: the exponent, or the roughness, is
// computed so that the rim stays under the cursor. At the rim the highlight is half of its maximum possible
// value there.

/// Returns the highlight of a light at a point of a surface with that material, relative to its maximum over
/// all light directions there: (r.v)^n for Phong. Returns 0 if the surface faces away from the viewer or
/// has no highlight. Noise may raise the value slightly above 1.
[[nodiscard]] double highlight_share(const SurfaceView& view, const Light& light, const SeenPoint& point,
                                     const Material& material);

/// A light whose highlight is visible at a pixel.
struct HoveredHighlight {
    int light = -1;
    double share = 0;  // fraction of the highlight's possible maximum there, above 0
};

/// Returns the light whose highlight covers the pixel: it must be visible (more than 0.15 of full brightness)
/// and near its peak there (at least half of it). The brightest one wins. Returns nullopt on the background,
/// without the specular term, or under models without a highlight.
[[nodiscard]] std::optional<HoveredHighlight> highlight_under(const SurfaceView& view, glm::dvec2 pixel);

/// Returns the light whose highlight has its rim within `reach` pixels; less inside a small highlight, so
/// that its centre can be grabbed too. Returns nullopt on the background, without the specular term, or under
/// models without a highlight.
[[nodiscard]] std::optional<int> highlight_rim_under(const SurfaceView& view, glm::dvec2 pixel, double reach);

struct SizeDrag {
    Light light;
    int object = 0;  // index of the object with the material
    Material start;
};

/// Returns the material that puts the rim under `pixel`, or as near as its range allows. Returns nullopt on
/// the background, on other objects, or if the light has no highlight with any material.
[[nodiscard]] std::optional<Material> sized_highlight(const SizeDrag& drag, const SurfaceView& view,
                                                      glm::dvec2 pixel);

}  // namespace glint
