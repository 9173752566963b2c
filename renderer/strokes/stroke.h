#pragma once
// A stroke drawn over the shaded picture: the last step of a pixel's sum, in linear light, before exposure
// and transfer.

#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

/// `coverage`, 0 to 1: the share of the pixel that the stroke hides; at 1 all of it, however bright.
template <Number F> Vec3<F> drawn_over(Vec3<F> shaded, F coverage, Vec3<F> stroke) {
    return select<F>(coverage >= F(1), stroke, (F(1) - coverage) * shaded + coverage * stroke);
}

}  // namespace glint::inline GLINT_ISA
