#pragma once
// r = 2 n (n·l) − l in four steps, with a slider for the length of n.

#include "renderer/inspect/explain/explanation.h"
#include "ui/inspector/state.h"

namespace glint {

/// Numbers in the frame that the column shows; the picture draws the chosen step.
void mirror_section(WhyState& state, const ExplainedPoint& point, const ExplainedLight& light);

}  // namespace glint
