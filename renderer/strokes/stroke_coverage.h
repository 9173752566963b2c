#pragma once
// Lines to the share of each pixel that they cover.

#include <span>
#include <vector>

#include "renderer/strokes/stroke_lines.h"

namespace glint {

/// Share of a pixel that a stroke of `width_px` covers when the pixel's centre lies `distance_px` from the
/// stroke's middle: exact for a straight stroke along rows or columns, width below a pixel included.
[[nodiscard]] float stroke_share(float distance_px, float width_px);

/// Width x height, 0 to 1: the largest share of any line, so that lines that meet or lie on each other are no
/// darker there; ends are round. A line does not cover a pixel that shows another object in front of it. The
/// same bits for every order of the lines.
[[nodiscard]] std::vector<float> stroke_coverage(const Geometry& geometry, const Visibility& visibility,
                                                 std::span<const StrokeLine> lines, float width_px);

}  // namespace glint
