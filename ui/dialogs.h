#pragma once
// What lies over the window: the question about unsaved changes, the file browser, the sheet of keys.

#include "ui/ui.h"

namespace glint {

/// After the keys, before any window: a dialog that was left by Escape, or by what came between, is taken off
/// ImGui's list. A modal that is no longer drawn would hold up every window that appears (ImGui ends the
/// program).
void close_left_dialogs(const UiState& state);

void dialogs(UiState& state, const UiInput& input);

/// Files that were dropped on the window: the first is opened.
void take_dropped(UiState& state, const UiInput& input);

}  // namespace glint
