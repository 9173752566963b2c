#pragma once
// Tells a softened picture from one whose surfaces are lit differently and find room between their neighbours.

#include "renderer/diagnose/search/score.h"

namespace glint {

/// By how much the wrong picture's surfaces are shifted to the right and down from the drawing's, in pixels;
/// zero where that cannot be told, or is more than four. Every `rows`-th row is looked at.
[[nodiscard]] glm::vec2 fitted_shift(const Exhibit& exhibit, const Picture& drawn,
                                     const DisplayChange& change, int rows = 1);

/// Whether the wrong picture was neither blurred nor resampled: it steps from one side of a silhouette to the
/// other as hard as the drawing does, and no shift explains most of what differs on surfaces. False where the
/// drawing has too few such steps to tell.
[[nodiscard]] bool is_hard(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change);

/// Whether the surfaces of the wrong picture may be those of the drawing with each pixel mixed from it and
/// its eight neighbours, where it is shifted to: one mixture in all places has to explain a part of what
/// differs. Mixing moves brightness and makes none: where a wrong picture is nearly everywhere darker, or
/// nearly everywhere brighter, that mixture has to explain most of it. False where is_hard(). `change` is
/// soft.
[[nodiscard]] bool may_be_softened(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change);

}  // namespace glint
