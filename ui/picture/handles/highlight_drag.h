#pragma once
// A highlight is dragged: the light moves so that its specular term peaks under the cursor. It keeps its
// distance from the surface (a directional light its dome), a spot or a panel turns along with it.
//
// The direction in which (r.v)^n or (n.h)^n is largest is known: l is v mirrored at n. But falloff, a cone,
// the samples of a panel and the angles of microfacets shift the picture's peak away from there, and more so
// the duller the surface. So the search begins at the mirror direction and brings the slope of the specular
// term, over the pixels round the cursor, to zero.

#include <optional>
#include <vector>

#include "models/scene/light.h"
#include "ui/picture/surface_patch.h"

namespace glint {

struct HighlightDrag {
    Light start;
    glm::dvec3 grabbed{0};  // the place on the surface, world
    double distance = 1;    // of the light from it
    double nearer = 1;      // times the distance: what dragging in depth made of it
    // While it is dragged in depth, the pixel where the highlight stays; and how far from the cursor it is
    // since.
    std::optional<glm::dvec2> stays_at;
    glm::dvec2 beside{0};
};

/// Takes hold of a light by what it does at a point.
[[nodiscard]] HighlightDrag grab_highlight(const SurfaceView& view, const Light& light,
                                           const SeenPoint& point);
/// Takes hold of a light by what it does at a pixel; nothing on the background.
[[nodiscard]] std::optional<HighlightDrag> grab_highlight(const SurfaceView& view, const Light& light,
                                                          glm::dvec2 pixel);

/// Returns the light with its highlight's peak at `pixel`, drag.nearer times as far away as when grabbed.
/// Nothing if no light can do that: on the background, or where the surface turns away from the viewer.
[[nodiscard]] std::optional<Light> dragged_highlight(const HighlightDrag& drag, const SurfaceView& view,
                                                     glm::dvec2 pixel);

/// Applies one movement of the cursor. The highlight goes along; in depth it stays, and the light moves away
/// as the cursor goes up, by a factor e in a third of the picture (a directional light has no distance).
/// Returns the light, or nothing as above.
[[nodiscard]] std::optional<Light> moved_highlight(HighlightDrag& drag, const SurfaceView& view,
                                                   glm::dvec2 cursor_px, glm::dvec2 last_px, bool in_depth);

/// Returns the light moved in the direction `away` (world, unit) from `place`; a spot or a panel turns so
/// that it shines at `place` as it shone at the grabbed place.
[[nodiscard]] Light carried(const HighlightDrag& drag, const SurfaceView& view, glm::dvec3 place,
                            glm::dvec3 away, double nearer = 1);

}  // namespace glint
