#pragma once
// The output: a framebuffer as plain arrays.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

struct Picture {
    PictureSize size;
    std::vector<std::uint8_t> rgba;  // 4 bytes per pixel, top row first, alpha 255; the displayed colours
    std::vector<float> linear;  // 3 floats per pixel, same order: linear colour before exposure, unclamped;
                                // empty unless requested
    int samples = 1;            // per pixel

    [[nodiscard]] std::size_t pixel(int x, int y) const { return size.index(x, y); }
    [[nodiscard]] glm::vec3 linear_at(int x, int y) const {
        const float* p = &linear[3 * pixel(x, y)];
        return {p[0], p[1], p[2]};
    }
};

/// Which blocks of 16 pixels in a row are drawn: 1 if drawn, else 0. Each row has (width + 15) / 16 of them;
/// those beyond the end of the list are not drawn. Null: all blocks are drawn.
using BlockChoice = std::shared_ptr<const std::vector<std::uint8_t>>;

/// A component of a linear colour as a linear file stores it: times the exposure, clamped to the float range.
[[nodiscard]] inline float exposed(float linear, float exposure) {
    constexpr float most = std::numeric_limits<float>::max();
    return std::clamp(linear * exposure, -most, most);
}

}  // namespace glint
