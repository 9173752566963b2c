#pragma once
// The row at the top: menus, shading mode, reflection model, terms, undo and redo.

#include "ui/shell/layout.h"
#include "ui/ui.h"

namespace glint {

void toolbar(UiState& state, const Rect& area);

/// The row at the bottom: what a drag does now; what the last frame took and which stages were redone.
void status_line(UiState& state, const Rect& area);

}  // namespace glint
