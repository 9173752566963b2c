#pragma once
// What stands round the picture: the scene's column, the column that says why a pixel has its colour, and the
// rows above and below.

#include <string>

#include "ui/feature.h"
#include "ui/picture/screen.h"
#include "ui/shell/layout.h"
#include "ui/ui.h"

namespace glint {

struct UiState;

/// Where everything is in this frame: lay_out() of the window, with room for the open scene's caption.
/// ImGui's current font is the one that the caption is written in.
[[nodiscard]] Layout window_layout(const UiState& state);

/// What a feature shows in place of the scene's list in the left column; null: nothing.
[[nodiscard]] const LeftColumn* open_column(const UiState& state);

/// Returns the least width at which `text`, in ImGui's current font, takes no more lines than at `width`: the
/// lines are then about equally long, and none is a single word. At most `width`.
[[nodiscard]] float even_width(const std::string& text, float width);

/// What the open scene says of itself, below the picture.
void caption_line(const UiState& state, const Layout& layout);

/// The list of the scene and the selected item's panel. Where the window is narrow, WHY is a tab of it.
void left_column(UiState& state, const Layout& layout, const PictureView& view);

/// WHY, wherever it is. After the picture was drawn, so that its numbers are of the picture on the screen.
void inspector_columns(UiState& state, const Layout& layout, const PictureView& view);

/// The row at the top: menus, shading mode, reflection model, terms, undo and redo.
void toolbar(UiState& state, const Rect& area);

/// The row at the bottom: what a drag does now; what the last frame took and which stages were redone.
void status_line(UiState& state, const Rect& area);

}  // namespace glint
