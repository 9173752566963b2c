#pragma once
// The outside view is a line drawing of the eye with its view volume, the axes of the world and the camera,
// and the lights, with those attached to the camera marked. Its own camera is not part of any scene.

#include <imgui.h>

#include "models/scene/scene.h"
#include "ui/picture/screen.h"

namespace glint {

struct UiState;

struct OutsideState {
    Camera camera;
    bool placed = false;  // otherwise the camera is placed when the view is next drawn
};

/// A camera that sees the target, the eye and all lights (directional ones on their dome) in a picture of
/// this size: from the side of the scene's own camera and above it.
[[nodiscard]] Camera outside_camera(const Scene& scene, const PictureView& main, PictureSize size);

/// Draws into the current window. Dragging orbits, the wheel zooms, a click selects a light; the scene's
/// camera does not move.
void outside_tab(UiState& state, const PictureView& main);

// Functions that draw the view's lines.

struct OutsideScene {
    const Scene& scene;
    const PictureView& main;  // the view of the scene's own camera
    int selected_light = -1, hovered_light = -1;
};

/// The depth to which the view volume is drawn: slightly behind the target, since the far plane may be
/// anywhere.
[[nodiscard]] double drawn_depth(const Camera& camera);

/// The length at which the camera's and the world's axes are drawn.
[[nodiscard]] double axis_length(const Camera& camera);

/// Draws meshes (only some of the edges of large ones), the eye, its view volume and axes, the world's axes
/// and the lights, as seen in `view`.
void draw_outside(ImDrawList& list, const PictureView& view, const OutsideScene& what);

}  // namespace glint
