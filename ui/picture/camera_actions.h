#pragma once
// What keys and menus do with the camera.

#include "ui/commands/actions.h"

namespace glint {

/// Does the action if it is one of the camera's views; true when it was.
bool run_camera_action(UiState& state, Action action);

}  // namespace glint
