#pragma once
// The menus, filled from the table of actions.

#include "ui/ui.h"

namespace glint {

/// Between ImGui::BeginMenuBar() and EndMenuBar().
void menu_bar(UiState& state);

}  // namespace glint
