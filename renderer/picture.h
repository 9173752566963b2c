#pragma once
// What comes out: the framebuffer, as plain arrays.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "models/scene/camera.h"

namespace glint {

struct Picture {
    PictureSize size;
    std::vector<std::uint8_t> rgba;  // 4 bytes a pixel, first row at the top, alpha 255; what is displayed
    std::vector<float> linear;  // 3 floats a pixel, same order: linear colour before exposure, unclamped;
                                // empty unless asked for
    int samples = 1;            // a pixel, with which it was drawn

    [[nodiscard]] std::size_t pixel(int x, int y) const { return size.index(x, y); }
    [[nodiscard]] glm::vec3 linear_at(int x, int y) const {
        const float* p = &linear[3 * pixel(x, y)];
        return {p[0], p[1], p[2]};
    }
};

/// A component of a linear colour as a linear file holds it: times the exposure, held where floats end.
[[nodiscard]] inline float exposed(float linear, float exposure) {
    constexpr float most = std::numeric_limits<float>::max();
    return std::clamp(linear * exposure, -most, most);
}

}  // namespace glint
