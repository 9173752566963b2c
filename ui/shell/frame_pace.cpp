#include "ui/shell/frame_pace.h"

#include <algorithm>
#include <cmath>

#include "models/saturate.h"

namespace glint {

void end_of_motion(FramePace& pace) {
    pace.divisor = 1;
    pace.in_vain = false;
}

void picture_took(FramePace& pace, int divisor, double ms) {
    const double pixels_fewer = double(divisor) * divisor;
    if (divisor == 1) {
        pace.full_ms = ms;
    } else if (ms > 0.8 * pace.full_ms) {
        pace.in_vain = true;
    } else if (ms * pixels_fewer > pace.full_ms || ms * pixels_fewer < wanted_picture_ms / 2) {
        // Dearer than thought, or cheap by far: small pictures have costs that do not shrink, so that in
        // between nothing follows for a full one.
        pace.full_ms = ms * pixels_fewer;
    }
    if (pace.in_vain || pace.full_ms <= pace.slow_ms) {
        pace.divisor = 1;
        return;
    }
    const int wanted = saturated_int(std::ceil(std::sqrt(pace.full_ms / wanted_picture_ms)));
    // Within a motion it only gets coarser: a picture that changes its grain is worse than a coarse one.
    pace.divisor = std::clamp(std::max(wanted, divisor), 2, largest_divisor);
}

PictureSize divided(PictureSize full, int divisor) {
    return {std::max(full.width / divisor, 1), std::max(full.height / divisor, 1)};
}

}  // namespace glint
