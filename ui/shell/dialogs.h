#pragma once
// The dialogs: the questions before work is lost, the file browser, the export.

#include "ui/ui.h"

namespace glint {

/// Draws the one that is asked for, and does what it is answered. Last in a frame: ui/widgets/modal.h.
void dialogs(UiState& state, const UiInput& input);

/// Files that were dropped on the window: the first is opened.
void take_dropped(UiState& state, const UiInput& input);

}  // namespace glint
