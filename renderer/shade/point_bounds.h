#pragma once
// Part of stage 4: bounds of neighbouring pixels' places and normals, by which a light is known to leave them
// dark.

#include "renderer/shade/shade_kernels.h"
#include "renderer/surface/surface.h"

namespace glint {

/// Of all runs of a surface whose lit points are its pixels, 16 runs a block; of other kinds, which have few
/// lit points, none.
void bound_pixels(const Surface& surface, std::vector<ReachBlock>& bounds);

}  // namespace glint
