#pragma once
// The scene from outside: the eye with what it sees, the axes of world and camera, the lights, and which of
// them ride with the camera. Drawn in lines, from a camera of its own that no scene knows.

#include "models/scene/camera.h"
#include "ui/picture/picture_view.h"

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

}  // namespace glint
