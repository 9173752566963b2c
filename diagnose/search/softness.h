#pragma once
// Distinguishes a softened picture from one with wrong lighting. A single wrong colour is not enough: it may
// be between the colours of its neighbours by chance.

#include "diagnose/search/score.h"

namespace glint {

/// Returns how far the wrong picture's surfaces are shifted to the right and down from the drawing's, in
/// pixels; zero if the shift is unknown or more than four pixels. Reads every `rows`-th row.
[[nodiscard]] glm::vec2 fitted_shift(const Exhibit& exhibit, const Picture& drawn,
                                     const DisplayChange& change, int rows = 1);

/// Whether the wrong picture's silhouettes are much softer than those of the drawing: they are anti-aliased.
[[nodiscard]] bool has_smooth_edges(const Exhibit& exhibit, const Drawing& drawn,
                                    const DisplayChange& change);

/// Whether the wrong picture was neither blurred nor resampled: its silhouettes are as sharp as the
/// drawing's, and no shift explains most of the difference on surfaces. False if the drawing has too few
/// sharp edges to decide.
[[nodiscard]] bool is_hard(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change);

/// Whether the surfaces of the wrong picture may be those of the drawing, blurred and perhaps shifted. One
/// filter kernel of 3 x 3 pixels, the same everywhere, must explain a part of the difference. A blur spreads
/// brightness but adds none: if the wrong picture is nearly everywhere darker, or nearly everywhere brighter,
/// the kernel must explain most of the difference. Returns false if is_hard(). Precondition: `change` is
/// soft.
[[nodiscard]] bool may_be_softened(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change);

// Noise: of a renderer that samples, of dithering, of a camera.

/// Returns the standard deviation, in levels, of noise that is independent from pixel to pixel; 0 where the
/// picture has little, or not clearly more than `right`, which has none. `wrong` and `right` have one size.
/// Source: J. Immerkær, Fast Noise Variance Estimation, Computer Vision and Image Understanding 64(2), 1996.
/// We take the median in place of the mean, and only over areas: edges and creases are few pixels, in lines.
[[nodiscard]] float noise_of(const Picture& wrong, const Picture& right);

}  // namespace glint
