#pragma once
// The sheet of keys and of what the mouse does (F1 or ?).

#include "ui/ui.h"

namespace glint {

void shortcuts_sheet(UiState& state);

}  // namespace glint
