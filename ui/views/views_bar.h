#pragma once
// The row above the picture: what shows in it and what lies over it.

#include "ui/ui.h"

namespace glint {

/// Draws the row into the current window.
void views_bar(UiState& state);

}  // namespace glint
