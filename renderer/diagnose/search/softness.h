#pragma once
// Tells a softened picture from one whose surfaces are lit otherwise and find room between their neighbours.

#include "renderer/diagnose/search/score.h"

namespace glint {

/// Whether the surfaces of the wrong picture may be those of the drawing with each pixel mixed from it and
/// its eight neighbours. Mixing moves brightness and makes none: where a wrong picture is nearly everywhere
/// darker, or nearly everywhere brighter, one mixture has to explain it in all places. `change` is soft.
[[nodiscard]] bool may_be_softened(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change);

}  // namespace glint
