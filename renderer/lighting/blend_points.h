#pragma once
// Colours of many pixels at once from the colours of lit points: Gouraud blends some, flat shows one.

#include "renderer/lighting/light_job.h"
#include "renderer/shading/interpolate.h"

namespace glint::inline GLINT_ISA {

/// The colours of the lit points with these numbers.
template <Number F> Vec3<F> colors_of(const ColorBlock* points, IntOf<F> number) {
    static_assert(block_size == 16 && sizeof(ColorBlock) == 48 * sizeof(float));
    const IntOf<F> block = number >> 4;
    const IntOf<F> at = (block << 5) + (block << 4) + (number & 15);  // 48 floats a block
    return {gather<F>(points->r, at), gather<F>(points->g, at), gather<F>(points->b, at)};
}

/// A run of pixels under Gouraud: `each` lit points a pixel, their numbers and weights 16 side by side.
template <Number F>
Vec3<F> blended_colors(const ColorBlock* points, const std::uint32_t* number, const float* weight, int each) {
    Vec3<F> sum;
    for (int k = 0; k < each; ++k, number += block_size, weight += block_size)
        sum = add_weighted(sum, load<F>(weight), colors_of<F>(points, load_ints<IntOf<F>>(number)));
    return sum;
}

}  // namespace glint::inline GLINT_ISA
