#pragma once
// The panel below the picture: intensity along the scope's line.

#include <string>

#include "ui/shell/layout.h"
#include "ui/views/scope.h"

namespace glint {

/// What was done in the panel beyond the scope itself.
struct ScopeWishes {
    bool copy = false;  // the command line to the clipboard
};

/// Draws the panel over `area`. `size`: of the picture that the samples are of.
[[nodiscard]] ScopeWishes scope_panel(ScopeState& scope, const Rect& area, PictureSize size);

}  // namespace glint
