#pragma once
// What the window does for looking at the picture: the row above it, tools upon it, panels below it. One
// place for ui.cpp to call.

#include <imgui.h>

#include <optional>
#include <string>

#include "ui/shell/layout.h"
#include "ui/ui.h"
#include "ui/views/compare_view.h"
#include "ui/views/scope.h"

namespace glint {

/// Shows one quantity in place of the picture. It and a comparison take each other's place.
void show_quantity(ViewsState& views, DebugView view, bool keep_comparing = false);

/// Before the layout: panels that are open ask for their room.
void begin_views(UiState& state);

/// Whether something shown is read off Picture::linear.
[[nodiscard]] bool views_need_linear(const ViewsState& views);

/// After the picture was drawn, or kept.
void update_views(UiState& state);

/// The row above the picture and the panel below.
void views_windows(UiState& state, const Layout& layout);

/// B pressed stays, B held goes back when it is let go of. Once a frame, after the keys' actions.
void follow_b_key(UiState& state, bool held);

// The row above the picture: what shows in it and what lies over it.

/// Draws the row into the current window.
void views_bar(UiState& state);

// What the row above the picture says and sets of a comparison.

/// Draws it into the current line; nothing while no comparison is on.
void compare_controls(CompareState& state);

// The panel below the picture: intensity along the scope's line.

/// What was done in the panel beyond the scope itself.
struct ScopeRequests {
    bool copy = false;  // the command line to the clipboard
};

/// Draws the panel over `area`. `size`: of the picture that the samples are of.
[[nodiscard]] ScopeRequests scope_panel(ScopeState& scope, const Rect& area, PictureSize size);

}  // namespace glint
