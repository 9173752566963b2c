#pragma once
// Noise in a picture under diagnosis: of a renderer that samples, of dithering, of a camera.

#include "renderer/picture.h"

namespace glint {

/// Returns the standard deviation, in levels, of noise that is independent from pixel to pixel; 0 where the
/// picture has little, or not clearly more than `right`, which has none. `wrong` and `right` have one size.
/// Source: J. Immerkær, Fast Noise Variance Estimation, Computer Vision and Image Understanding 64(2), 1996.
/// We take the median in place of the mean, and only over areas: edges and creases are few pixels, in lines.
[[nodiscard]] float noise_of(const Picture& wrong, const Picture& right);

}  // namespace glint
