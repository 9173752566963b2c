#pragma once
// Dragging a light by its terminator, the line on a surface where n.l = 0: the light moves, as little as it
// must, into the plane that touches the surface under the cursor.

#include <optional>

#include "models/scene/light.h"
#include "ui/picture/handles/highlight_drag.h"

namespace glint {

struct TerminatorDrag {
    Light start;
};

/// Whether the light's terminator passes within `reach` pixels of `pixel`.
[[nodiscard]] bool terminator_under(const SurfaceView& view, const Light& light, glm::dvec2 pixel,
                                    double reach);

/// The light with its terminator through `pixel`: a place goes straight down onto the tangent plane, a
/// direction is turned into it. Nothing on the background, and where the light stands right above the pixel.
[[nodiscard]] std::optional<Light> dragged_terminator(const TerminatorDrag& drag, const SurfaceView& view,
                                                      glm::dvec2 pixel);

}  // namespace glint
