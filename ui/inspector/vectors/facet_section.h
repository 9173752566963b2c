#pragma once

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;

/// The picked facet's edges, their cross product and its length, and Newell's normal.
void facet_section(UiState& state, const Explanation& why);

}  // namespace glint
