#pragma once
// Several samples a pixel: which faces each pixel shows, with what share of its samples.

#include "renderer/surface/surface.h"

namespace glint {

/// Fills groups, group_samples and pixel_count from all planes of the visibility, in reading order.
void find_sampled_groups(Surface& surface, const Geometry& geometry, const Visibility& visibility);

}  // namespace glint
