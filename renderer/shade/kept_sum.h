#pragma once
// Part of stage 4: while one light alone is dragged, the sum of the others at each point is kept.

#include "renderer/shade/lighting.h"

namespace glint {

/// The index of the only light that differs, or -1 when none or several do.
[[nodiscard]] int changed_light(const std::vector<Light>& kept, const std::vector<Light>& now);

/// Decides whether the sum of all lights but one can be used, and brings it up to date. `moving`: the only
/// light that differs from the frame before, or -1.
void keep_others(Lighting& lighting, const Surface& surface, int moving, bool same_grids);

}  // namespace glint
