#pragma once
// The parts around the picture: the scene's column, the column that explains a pixel's colour, and the bars
// above and below.

#include <string>

#include "ui/feature.h"
#include "ui/picture/screen.h"
#include "ui/shell/layout.h"
#include "ui/ui.h"

namespace glint {

struct UiState;

/// Returns this frame's layout: lay_out() for the window, with room for the open scene's caption. ImGui's
/// current font must be the caption's.
[[nodiscard]] Layout window_layout(const UiState& state);

/// Returns the feature column that replaces the scene's list in the left column; null: none.
[[nodiscard]] const LeftColumn* open_column(const UiState& state);

/// Draws the open scene's caption, below the picture.
void caption_line(const UiState& state, const Layout& layout);

/// Draws the scene's list and the selected item's panel. In a narrow window, WHY is a tab of this column.
void left_column(UiState& state, const Layout& layout, const PictureView& view);

/// Draws WHY, in either column. Drawn after the picture, so that its numbers belong to the picture on the
/// screen.
void inspector_columns(UiState& state, const Layout& layout, const PictureView& view);

/// Draws the row at the top: menus, shading mode, reflection model, terms, undo and redo.
void toolbar(UiState& state, const Rect& area);

/// Draws the row at the bottom: what a drag does now, the time of the last frame, and the stages that ran.
void status_line(UiState& state, const Rect& area);

}  // namespace glint
