#pragma once
// What stands above the tabs of WHY: the picked pixel, its colour, and what shows there.

#include "renderer/inspect/explanation.h"

namespace glint {

struct UiState;

/// A square of the pixel's colour with its byte values, the pixel, and what it shows. A click on the object
/// selects it, a click on the cross forgets the pixel.
void why_heading(UiState& state, const Explanation& why);

/// How to ask, where no pixel is picked: `promise` says what this tab would show.
void why_empty_state(const char* promise);

}  // namespace glint
