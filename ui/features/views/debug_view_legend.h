#pragma once
// The room that the legend of a false colour takes: what else lies over the picture keeps off it.

#include "ui/features/views/debug_view_controls.h"

namespace glint {

/// How wide the legend is that draw_debug_view_legend() draws at the picture's left edge; 0: none.
[[nodiscard]] float legend_width(const DebugViewState& state);

}  // namespace glint
