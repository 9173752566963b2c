#pragma once
// What the window does for looking at the picture: the row above it, tools upon it, panels below it. One
// place for ui.cpp to call.

#include <imgui.h>

#include <optional>
#include <string>

#include "ui/shell/layout.h"
#include "ui/ui.h"

namespace glint {

/// Shows one quantity in place of the picture. It and a comparison take each other's place.
void look_at(ViewsState& views, Look look, bool keep_comparing = false);

/// Before the layout: panels that are open ask for their room.
void begin_views(UiState& state);

/// Reads the mouse over the item drawn last (the picture). True while a view's tool has it: then no gesture
/// may take it.
[[nodiscard]] bool views_hand(UiState& state, const PictureView& view);

/// Whether something shown is read off Picture::linear.
[[nodiscard]] bool views_need_linear(const ViewsState& views);

/// After the picture was drawn, or kept.
void update_views(UiState& state);

/// Over the picture.
void draw_views_overlay(ImDrawList& list, UiState& state, const PictureView& view);

/// The row above the picture and the panel below.
void views_windows(UiState& state, const Layout& layout);

/// What a drag or click would do for a view's tool, for the status line; empty when none has the mouse.
[[nodiscard]] std::string views_hint(const ViewsState& views);

/// B pressed stays, B held goes back when it is let go of. Once a frame, after the keys' actions.
void follow_b_key(UiState& state, bool held);

/// Escape: puts the tool in hand away. False when there is none.
bool leave_view_tool(ViewsState& views);

}  // namespace glint
