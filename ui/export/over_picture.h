#pragma once
// The frame of what lies over the picture's upper edge for a while: what is being loaded, the offer of a lost
// copy.

#include "ui/shell/layout.h"

namespace glint {

/// Begins a panel over the picture's middle, at most `widest` wide and never cut off at the window's left;
/// end_over_picture must follow. Returns its width. `more`: further ImGuiWindowFlags.
float begin_over_picture(const char* id, float widest, const Rect& picture, int more = 0);
void end_over_picture();

}  // namespace glint
