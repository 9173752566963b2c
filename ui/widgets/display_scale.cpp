#include "ui/widgets/display_scale.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr float least_scale = 0.75f, max_scale = 4;  // dots per logical pixel
constexpr float least_dots = 0.5f, max_dots = 4;     // per unit of the window

/// Whether `dots` is `units` times `ratio`, rounded up or down to whole dots.
bool fits(int units, int dots, float ratio) {
    return std::abs(static_cast<float>(units) * ratio - static_cast<float>(dots)) <= 1;
}

float dots_per_unit(const WindowExtent& extent, float before) {
    const glm::ivec2 size = extent.size, dots = extent.dots;
    if (size != extent.size_after || size.x <= 0 || size.y <= 0 || dots.x <= 0 || dots.y <= 0) return before;
    if (fits(size.x, dots.x, before) && fits(size.y, dots.y, before)) return before;
    const float ratio = static_cast<float>(dots.x) / static_cast<float>(size.x);
    // Units are square. If the height does not match the ratio, the two values belong to different sizes.
    if (!fits(size.y, dots.y, ratio)) return before;
    return std::clamp(ratio, least_dots, max_dots);
}

}  // namespace

DisplayScale display_scale(const WindowExtent& extent, const DisplayScale& before) {
    DisplayScale scale;
    scale.dots_per_unit = dots_per_unit(extent, before.dots_per_unit);
    const float content = std::isfinite(extent.content_scale) ? extent.content_scale : 1;
    scale.design = std::clamp(content, least_scale, max_scale) / scale.dots_per_unit;
    return scale;
}

}  // namespace glint
