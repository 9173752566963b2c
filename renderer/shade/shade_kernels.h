#pragma once
// The inputs and outputs of the shading kernels as plain numbers, shared by all instruction sets.

#include "renderer/lighting/light_job.h"

namespace glint {

/// The colour of one lit point, linear RGB, not clamped. The record is loaded in one step.
struct ColorRecord {
    float r = 0, g = 0, b = 0, unused = 0;
};

/// Bounds of 16 blocks of points: for each a bounding sphere of the positions and one of the normals
/// (GroupBounds).
struct alignas(64) BoundsBlock {
    float x[block_size], y[block_size], z[block_size], radius[block_size];
    float nx[block_size], ny[block_size], nz[block_size], spread[block_size];
};

/// The kernels of one instruction set.
struct ShadeKernels {
    /// Bit i: whether the light may contribute to a point of block i.
    std::uint16_t (*find_lit)(const LightSource& light, const BoundsBlock& bounds);
    /// Compute groups of 16 pixels from the colours of lit points. blend() blends `each` points, with numbers
    /// and weights [group][which][pixel]; pick() copies one point, with numbers [group][pixel].
    void (*blend)(const ColorRecord* points, const std::uint32_t* numbers, const float* weights, int each,
                  ColorBlock* colors, std::size_t groups);
    void (*pick)(const ColorRecord* points, const std::uint32_t* numbers, ColorBlock* colors,
                 std::size_t groups);
};

/// The kernels of the selected instruction set (renderer/simd/isa/kernel_set.h).
const ShadeKernels& shade_kernels();

}  // namespace glint
