#pragma once
// What stands above the tabs of WHY: the picked pixel, its colour, and what shows there.

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;

/// A square of the pixel's colour with its byte values, the pixel, and what it shows. A click on the object
/// selects it, a click on the cross forgets the pixel. As high while no pixel is picked, when it says how to
/// pick one: the tabs below it stay where they are.
void why_heading(UiState& state);

/// What a tab that needs a pixel shows while none is picked: `promise` says what it would.
void why_empty_state(const char* promise);

}  // namespace glint
