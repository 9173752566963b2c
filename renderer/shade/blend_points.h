#pragma once
// Colours of many pixels at once from the colours of lit points: Gouraud blends some, flat shows one.

#include "renderer/geometry/interpolate.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/simd/transpose.h"

namespace glint::inline GLINT_ISA {

/// The colours of the lit points with these numbers.
template <Number F> Vec3<F> colors_of(const ColorRecord* points, const std::uint32_t* number) {
    const Columns<F> color = gather_transposed<F>(points, number, sizeof(ColorRecord));
    return {color.a, color.b, color.c};
}

/// A run of pixels under Gouraud: `each` lit points a pixel, their numbers and weights 16 side by side.
template <Number F>
Vec3<F> blended_colors(const ColorRecord* points, const std::uint32_t* number, const float* weight,
                       int each) {
    Vec3<F> sum;
    for (int k = 0; k < each; ++k, number += block_size, weight += block_size)
        sum = add_weighted(sum, load<F>(weight), colors_of<F>(points, number));
    return sum;
}

}  // namespace glint::inline GLINT_ISA
