#pragma once

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;

/// The review's table, live at the picked point: how far each term moves when normal, light or viewer is
/// turned by a degree.
void needs_section(const UiState& state, const ExplainedPoint& point, const ExplainedLight& light);

}  // namespace glint
