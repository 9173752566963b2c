#pragma once
// What lies over the window: the question about unsaved changes, the file browser, the sheet of keys.

#include "ui/ui.h"

namespace glint {

void dialogs(UiState& state, const UiInput& input);

/// Files that were dropped on the window: the first is opened.
void take_dropped(UiState& state, const UiInput& input);

}  // namespace glint
