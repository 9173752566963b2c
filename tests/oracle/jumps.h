#pragma once
// The pixels that cannot be compared, by rule: where the lighting equation itself jumps, so that rounding
// decides what is seen, and one defect of Mesa. Nothing else is excused.

#include <cstddef>

#include "models/scene.h"
#include "renderer/inspect/explanation.h"

namespace glint::oracle {

enum class Jump {
    None,
    GrazingLight,  // n.l = 0: the highlight is cut off
    LightBehind,   // l = -v: the half vector has no direction
    SpotEdge,      // on the cone's edge, which is inside for us and outside for Mesa
    GrazingView,   // n.v = 0 under cook-torrance: the highlight is cut off
    CutOnScreen  // interpolated on the screen over a triangle that leaves the view: where Mesa's clipper cuts
                 // one twice, at a corner of the picture, its new corners' values are no numbers
};
inline constexpr std::size_t jump_count = 6;

/// The first of these at any point that the pixel's sum is made of.
[[nodiscard]] Jump jump_at(const Scene& scene, PictureSize size, const Explanation& e);

}  // namespace glint::oracle
