#pragma once
// What a vertex in clip coordinates lies outside of.

#include <cstdint>

namespace glint {

/// The six planes of the view volume, and a guard band around the picture, beyond which screen coordinates
/// would not fit the rasteriser's integers.
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

}  // namespace glint
