#include "renderer/diagnose/search/noise.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace glint {
namespace {

/// What the mask (1 -2 1, -2 4 -2, 1 -2 1) gives at most: 16 times a channel's range.
constexpr std::size_t responses = 16 * 255 + 1;

/// The median of the mask's amounts over all channels of all pixels around which a picture is not of one
/// colour; 0 where there is none. The mask answers 0 to all that is linear or constant along rows or columns.
std::size_t median_response(const Picture& picture) {
    std::array<std::uint64_t, responses> counts{};
    std::uint64_t all = 0;
    for (int y = 1; y + 1 < picture.size.height; ++y)
        for (int x = 1; x + 1 < picture.size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                constexpr std::array<int, 3> weight{1, -2, 1};
                const int middle = picture.rgba[4 * picture.pixel(x, y) + c];
                int sum = 0;
                bool flat = true;
                for (int v = 0; v < 3; ++v)
                    for (int u = 0; u < 3; ++u) {
                        const int level = picture.rgba[4 * picture.pixel(x + u - 1, y + v - 1) + c];
                        sum += weight[std::size_t(u)] * weight[std::size_t(v)] * level;
                        flat = flat && level == middle;
                    }
                if (flat) continue;
                ++counts[static_cast<std::size_t>(std::abs(sum))];
                ++all;
            }
    std::uint64_t below = 0;
    std::size_t median = 0;
    while (median + 1 < responses && 2 * (below + counts[median]) < all) below += counts[median++];
    return median;
}

}  // namespace

float noise_of(const Picture& wrong, const Picture& right) {
    constexpr std::size_t least = 4, more_than_right = 2;  // rounding alone gives 1 or 2
    // The mask's answer has 6 times the deviation of the noise, and the median of its amount is 0.6745 of
    // that.
    constexpr float median_of_unit = 6 * 0.6745f;
    const std::size_t median = median_response(wrong);
    if (median < least || median < more_than_right * median_response(right)) return 0;
    return static_cast<float>(median) / median_of_unit;
}

}  // namespace glint
