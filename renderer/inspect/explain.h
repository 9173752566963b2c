#pragma once
// Why a pixel has its colour: the picture's own functions, run once more with `float`, every step kept.

#include "renderer/inspect/explanation.h"
#include "renderer/kept_stages.h"

namespace glint {

/// Precondition: the stages hold a drawn picture and (x, y) is inside it.
[[nodiscard]] Explanation explain_pixel(const KeptStages& stages, int x, int y);

}  // namespace glint
