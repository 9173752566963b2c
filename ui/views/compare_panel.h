#pragma once
// What the row above the picture says and sets of a comparison.

#include "ui/views/compare_view.h"

namespace glint {

/// Draws it into the current line; nothing while no comparison is on.
void compare_controls(CompareState& state);

}  // namespace glint
