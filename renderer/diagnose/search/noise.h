#pragma once
// Noise in a picture under diagnosis: of a renderer that samples, of dithering, of a camera.

#include "renderer/picture.h"

namespace glint {

/// Returns the standard deviation, in levels, of noise that is independent from pixel to pixel; 0 where the
/// picture has little, or not clearly more than `right`, which has none. `wrong` and `right` have one size.
/// Source: J. Immerkær, Fast Noise Variance Estimation, Computer Vision and Image Understanding 64(2), 1996,
/// with the median for the mean, of areas alone: edges and creases are few, and lines.
[[nodiscard]] float noise_of(const Picture& wrong, const Picture& right);

}  // namespace glint
