#pragma once
// Rounds each light's contribution, so that the contributions of many lights can be added exactly and in any
// order. While one light is dragged, the sum of all others can then be cached
// (renderer/shade/moving_light.h), and the picture is bit-identical to adding all lights again.

#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

/// Returns the `magic` argument of rounded(): 1.5 * 2^23 * grid. grid: a power of two, or 0.
inline float rounding_magic(float grid) { return grid * 12582912.0f; }

/// Rounds each component to the nearest multiple of `grid` by adding and subtracting `magic`; floats near
/// `magic` are `grid` apart. Precondition: |c| <= 2^22 grid. Multiples of grid add exactly, in any order, as
/// long as the sum stays within 2^24 grid. magic = 0: no rounding.
template <Number F> Vec3<F> rounded(Vec3<F> c, float magic) {
    return {(c.x + F(magic)) - F(magic), (c.y + F(magic)) - F(magic), (c.z + F(magic)) - F(magic)};
}

}  // namespace glint::inline GLINT_ISA
