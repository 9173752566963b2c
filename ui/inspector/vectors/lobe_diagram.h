#pragma once
// The plane of incidence at the picked point, seen from the side: n up, l, r, h and v with their angles, and
// the lobe of what this surface reflects of this light.

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;

/// As wide as the column. The lobe is that of renderer/inspect/lobes, in the channel chosen in the equation.
void lobe_diagram(const UiState& state, const ExplainedPoint& point, const ExplainedLight& light);

}  // namespace glint
