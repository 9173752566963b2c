#pragma once
// When the picture is drawn, and how large.

#include "ui/gizmo.h"

namespace glint {

struct UiState;

/// Draws what shows (the edited scene or a preview) if it, or the size, is not that of the last picture; then
/// asks the edited scene about the probe. While a hand moves something, a picture that would take too long is
/// a smaller one (ui/frame_pace.h).
void draw_picture(UiState& state, const PictureView& view);

/// Learns how long the pictures of this frame took, those of a comparison's parts included. After
/// update_views().
void learn_pace(UiState& state);

}  // namespace glint
