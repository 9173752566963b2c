#pragma once
// The room in the middle of the window: the picture, the hand on it, and what is drawn over it.

#include "ui/commands/keys.h"
#include "ui/picture/picture_view.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

/// Where the picture goes and how large it is in real pixels.
[[nodiscard]] PictureView picture_view(const Rect& centre, const UiState& state);

/// Places the picture and reads what a hand does on it. True while a gesture has the scene in hand.
[[nodiscard]] bool picture_room(UiState& state, const Layout& layout, const UiInput& input);

/// Handles, vectors, views, the pen; notifications. After the picture was drawn, so that they agree with it.
void picture_overlay(UiState& state, const Layout& layout, const PictureView& view);

}  // namespace glint
