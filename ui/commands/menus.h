#pragma once
// The menus, filled from the table of actions.

#include "ui/ui.h"

namespace glint {

/// Between ImGui::BeginMenuBar() and EndMenuBar().
void menu_bar(UiState& state);

// The sheet of keys and of what the mouse does (F1 or ?).

void shortcuts_sheet(UiState& state);

// Ctrl+K: type a few letters of anything that the window can do.

/// Everything there is to do in this state: the actions, one for each reflection model and the other
/// switches of shading and display, mistakes, presets for the selected object, lights to switch and items to
/// select, scenes to open.
[[nodiscard]] std::vector<PaletteEntry> palette_entries(const UiState& state);

/// Indices of the entries that match, best first; all of them, in their order, for an empty text.
[[nodiscard]] std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries,
                                               const std::string& text);

void open_palette(UiState& state);
void palette(UiState& state, const UiInput& input);

}  // namespace glint
