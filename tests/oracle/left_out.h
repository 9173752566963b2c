#pragma once
// Rules for pixels that cannot be compared: where the equation is discontinuous, so that rounding decides;
// where Glint's definition differs from OpenGL's; and where Mesa fails. All other differences count.

#include <cstddef>

#include "models/scene/scene.h"
#include "renderer/explain/explain.h"

namespace glint::oracle {

enum class LeftOut {
    None,
    GrazingLight,  // n.l = 0: the highlight is cut off
    LightBehind,   // l = -v: the half vector has no direction
    SpotEdge,      // on the cone's edge, which is inside for Glint and outside for Mesa
    GrazingView,   // n.v = 0 under cook-torrance: the highlight is cut off
    // Under screen-linear interpolation:
    CutByNear,  // Glint clips first: its new corners have perspective-correct values; OpenGL stays linear
    CutTwice    // the triangle crosses two planes: Mesa's clipper gives the new corners NaN
};
inline constexpr std::size_t left_out_count = 7;

/// The first rule that applies at any point that contributes to the pixel.
[[nodiscard]] LeftOut left_out_at(const Scene& scene, PictureSize size, const Explanation& e);
/// The first rule about lighting that applies, for a program that interpolates as Glint does.
[[nodiscard]] LeftOut left_out_by_lighting(const Scene& scene, const Explanation& e);

}  // namespace glint::oracle
