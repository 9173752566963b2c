#pragma once
// The pixels that cannot be compared, by rule: where the equation itself jumps, so that rounding decides what
// is seen; where our definition is not OpenGL's; and where Mesa fails. Nothing else is excused.

#include <cstddef>

#include "models/scene/scene.h"
#include "renderer/explain/explanation.h"

namespace glint::oracle {

enum class LeftOut {
    None,
    GrazingLight,  // n.l = 0: the highlight is cut off
    LightBehind,   // l = -v: the half vector has no direction
    SpotEdge,      // on the cone's edge, which is inside for us and outside for Mesa
    GrazingView,   // n.v = 0 under cook-torrance: the highlight is cut off
    // Under screen-linear interpolation:
    CutByNear,  // ours clips first and gives the new corners perspective-correct values; OpenGL stays linear
    CutTwice    // the triangle crosses two planes: what Mesa's clipper gives the new corners is not a number
};
inline constexpr std::size_t left_out_count = 7;

/// The first of these at any point that the pixel's sum is made of.
[[nodiscard]] LeftOut left_out_at(const Scene& scene, PictureSize size, const Explanation& e);
/// Returns the first that lighting has, for a program that interpolates as we do.
[[nodiscard]] LeftOut left_out_by_lighting(const Scene& scene, const Explanation& e);

}  // namespace glint::oracle
