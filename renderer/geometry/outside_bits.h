#pragma once
// What a vertex in clip coordinates lies outside of.

#include <cstdint>

namespace glint {

/// The six planes of the view volume, and a guard band: around the picture, beyond which screen coordinates
/// would not fit the rasteriser's integers, and around the lengths whose products floats hold.
enum OutsideBits : std::uint32_t {
    OutsideLeft = 1,
    OutsideRight = 2,
    OutsideBottom = 4,
    OutsideTop = 8,
    OutsideNear = 16,
    OutsideFar = 32,
    OutsideGuard = 64
};
inline constexpr std::uint32_t needs_clipping = OutsideNear | OutsideFar | OutsideGuard;

/// How far the guard band reaches, in half picture widths: |x|, |y| <= guard_band w. The largest picture,
/// 16384, times 32, times 256 subpixels, is 2^27: edge functions then fit 64 bits with room to spare.
inline constexpr double guard_band = 64;

/// Within these w, products of two corners' clip coordinates fit a float, and keep its digits where the
/// corners lie close together. Beyond, pixels are placed in doubles.
inline constexpr double min_float_w = 1e-12, max_float_w = 1e15;
/// So far from the eye a place may be for the square of its distance to fit a float.
inline constexpr double max_distance = 1e18;

}  // namespace glint
