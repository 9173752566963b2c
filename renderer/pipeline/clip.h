#pragma once
// Clipping in homogeneous coordinates, before anything is divided (OpenGL 2.1, section 2.12).

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace glint {

// Which planes a vertex lies outside of: the six of the view volume, and a guard band around the picture,
// beyond which screen coordinates would not fit the rasteriser's integers.
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

[[nodiscard]] inline std::uint32_t outside_bits(const glm::dvec4& c) {
    const double g = guard_band * c.w;
    std::uint32_t bits = 0;
    if (c.x < -c.w) bits |= OutsideLeft;
    if (c.x > c.w) bits |= OutsideRight;
    if (c.y < -c.w) bits |= OutsideBottom;
    if (c.y > c.w) bits |= OutsideTop;
    if (c.z < -c.w) bits |= OutsideNear;
    if (c.z > c.w) bits |= OutsideFar;
    if (!(c.x >= -g && c.x <= g && c.y >= -g && c.y <= g)) bits |= OutsideGuard;  // NaN counts as outside
    return bits;
}

/// The part of a convex polygon (clip coordinates) inside near, far and guard band, in the same order around;
/// empty when nothing is left. A cut edge gives the same new corner whichever of its two faces is clipped, so
/// that no crack opens. `spare` is memory to work in. Source: I. Sutherland, G. Hodgman 1974.
void clip_polygon(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& spare);

}  // namespace glint
