#pragma once
// The columns on either side of the picture: what is in the scene, and why a pixel has its colour.

#include "ui/picture/picture_view.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

/// The list of the scene and the selected item's panel. Where the window is narrow, WHY is a tab of it.
void left_column(UiState& state, const Layout& layout, const PictureView& view);

/// WHY, wherever it is. After the picture was drawn, so that its numbers are of the picture on the screen.
void why_columns(UiState& state, const Layout& layout, const PictureView& view);

}  // namespace glint
