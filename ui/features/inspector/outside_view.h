#pragma once
// The outside view draws in lines the eye with what it sees, the axes of world and camera, the lights, and
// which of them ride with the camera. It has a camera of its own that no scene knows.

#include <imgui.h>

#include "models/scene/scene.h"
#include "ui/picture/screen.h"

namespace glint {

struct UiState;

struct OutsideState {
    Camera camera;
    bool placed = false;  // else it is placed when it is drawn next
};

/// A camera that sees the target, the eye and all lights (directional ones on their dome) in a picture of
/// this size: from the side of the scene's own camera and above it.
[[nodiscard]] Camera outside_camera(const Scene& scene, const PictureView& main, PictureSize size);

/// Draws into the current window. Dragging turns, the wheel comes closer, a click selects a light; none of
/// that moves the scene's camera.
void outside_tab(UiState& state, const PictureView& main);

// Its lines are drawn by these.

struct OutsideScene {
    const Scene& scene;
    const PictureView& main;  // through which the scene's own camera sees it
    int selected_light = -1, hovered_light = -1;
};

/// How far the view volume is drawn, in depth: a little behind the target, since the far plane may be
/// anywhere.
[[nodiscard]] double drawn_depth(const Camera& camera);

/// How long the drawn axes are, of the camera and of the world.
[[nodiscard]] double axis_length(const Camera& camera);

/// Draws meshes (of large ones some of the edges), the eye, its view volume and axes, the world's axes and
/// the lights, as `view` shows them.
void draw_outside(ImDrawList& list, const PictureView& view, const OutsideScene& what);

}  // namespace glint
