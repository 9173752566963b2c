#pragma once
// Dragging a light in the picture: from a motion of the cursor to the light's new numbers. Pure functions;
// the handle stays under the cursor as exactly as float can hold the position.

#include <glm/vec2.hpp>

#include "models/scene/light.h"
#include "ui/picture/handles/light_place.h"
#include "ui/picture/screen.h"

namespace glint {

/// Along what a light moves. ViewPlane: parallel to the picture. Depth: along the line of sight, up is away
/// (a directional light instead turns round the picture's axes, past the rim of its dome). X, Y, Z: along an
/// axis of the light's own coordinates (directional: round it).
enum class DragAlong { ViewPlane, Depth, X, Y, Z };

/// A drag from the moment it began, or changed what it moves along.
struct LightDrag {
    Light start;
    DragAlong along = DragAlong::ViewPlane;
    glm::dvec2 grabbed_px{0};  // the cursor then; its distance from the handle is kept
};

/// What a drag needs to know of the view. It must not change while a drag lasts.
struct DragView {
    ScreenMap map;
    Dome dome;
    double snap_step = 0.25;  // scene units
};

/// The light after the cursor went to `cursor_px`. `snap`: coordinates to multiples of the view's step,
/// angles of a direction to multiples of 15 degrees. Where the motion has no answer (along an axis that is
/// seen end on, behind the eye) the light is the one the drag began with.
[[nodiscard]] Light dragged(const LightDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap);

/// A step of 1, 2 or 5 times a power of ten, near a twentieth of the scene's size.
[[nodiscard]] double snap_step_for(const Bounds& bounds);

}  // namespace glint
