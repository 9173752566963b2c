#pragma once
// I = emission + ambient + diffuse + specular in all three channels.

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;

/// A row a term, a column a channel; a click on a channel chooses whose products are written out. Pointing at
/// a term shows it alone in the picture.
void sum_table(UiState& state, const Explanation& why);

/// What becomes of the sum on its way to the screen: stroke, exposure, transfer, clipping.
void display_lines(const UiState& state, const Explanation& why);

}  // namespace glint
