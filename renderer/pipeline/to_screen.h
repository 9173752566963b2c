#pragma once
// Where a vertex lies on the rasteriser's grid. For those of triangles and of clipped pieces alike, so that
// no crack opens between them.

#include <glm/vec4.hpp>

#include "models/camera.h"
#include "renderer/pipeline/kernels/drawing_kernels.h"

namespace glint {

/// To the nearest whole number, halves away from zero: std::lround, which is a call and slower than all else
/// that a vertex needs.
inline std::int32_t nearest(double x) {
    const auto towards_zero = static_cast<std::int64_t>(x);
    const double rest = x - static_cast<double>(towards_zero);  // exact
    return static_cast<std::int32_t>(towards_zero + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0));
}

/// From clip coordinates to the rasteriser's grid.
struct ToScreen {
    PictureSize size;
    bool orthographic;

    [[nodiscard]] ScreenVertex operator()(const glm::dvec4& clip) const {
        const double x = (clip.x / clip.w + 1) * 0.5 * size.width * subpixels;
        const double y = (1 - clip.y / clip.w) * 0.5 * size.height * subpixels;
        const double nearness = orthographic ? 0.5 * (1 - clip.z / clip.w) : 1 / clip.w;
        return {nearest(x), nearest(y), static_cast<float>(nearness)};
    }
};

}  // namespace glint
