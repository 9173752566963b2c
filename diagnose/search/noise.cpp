#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "diagnose/search/softness.h"

namespace glint {
namespace {

/// The number of absolute responses of the mask (1 -2 1, -2 4 -2, 1 -2 1): up to 16 times a channel's range.
constexpr std::size_t responses = 16 * 255 + 1;

/// The mask's absolute response in one channel at a pixel; nothing where the pixel and its neighbours are
/// equal. The response is 0 where levels are linear or constant along rows or columns.
std::optional<std::size_t> response_at(const Picture& picture, int x, int y, std::size_t channel) {
    constexpr std::array<int, 3> weight{1, -2, 1};
    const int middle = picture.rgba[4 * picture.pixel(x, y) + channel];
    int sum = 0;
    bool flat = true;
    for (int v = 0; v < 3; ++v)
        for (int u = 0; u < 3; ++u) {
            const int level = picture.rgba[4 * picture.pixel(x + u - 1, y + v - 1) + channel];
            sum += weight[std::size_t(u)] * weight[std::size_t(v)] * level;
            flat = flat && level == middle;
        }
    if (flat) return {};
    return static_cast<std::size_t>(std::abs(sum));
}

/// The mask's response in one channel at every pixel; no_answer at the border and in areas of one colour.
constexpr std::uint16_t no_answer = 0xFFFF;
std::vector<std::uint16_t> answers_of(const Picture& picture, std::size_t channel) {
    std::vector<std::uint16_t> answers(picture.size.pixels(), no_answer);
    for (int y = 1; y + 1 < picture.size.height; ++y)
        for (int x = 1; x + 1 < picture.size.width; ++x)
            if (const auto response = response_at(picture, x, y, channel))
                answers[picture.size.index(x, y)] = static_cast<std::uint16_t>(*response);
    return answers;
}

/// Returns the median of the mask's absolute responses over all channels. The mask also responds to edges
/// between areas of one colour. Only noise gives responses on all sides of a pixel, so only such pixels are
/// counted. Returns 0 if they are fewer than one in four.
std::size_t median_response(const Picture& picture) {
    constexpr int apart = 3;          // beyond the mask's own width
    constexpr std::size_t share = 4;  // at least one response in this many is counted
    std::array<std::uint64_t, responses> counts{};
    std::uint64_t all = 0, answered = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<std::uint16_t> answers = answers_of(picture, c);
        const auto answers_at = [&](int x, int y) { return answers[picture.size.index(x, y)] != no_answer; };
        answered += static_cast<std::uint64_t>(
            std::count_if(answers.begin(), answers.end(), [](std::uint16_t a) { return a != no_answer; }));
        for (int y = apart; y + apart < picture.size.height; ++y)
            for (int x = apart; x + apart < picture.size.width; ++x) {
                if (!answers_at(x, y) || !answers_at(x - apart, y) || !answers_at(x + apart, y) ||
                    !answers_at(x, y - apart) || !answers_at(x, y + apart))
                    continue;
                ++counts[answers[picture.size.index(x, y)]];
                ++all;
            }
    }
    if (share * all < answered) return 0;
    std::uint64_t below = 0;
    std::size_t median = 0;
    while (median + 1 < responses && 2 * (below + counts[median]) < all) below += counts[median++];
    return median;
}

}  // namespace

float noise_of(const Picture& wrong, const Picture& right) {
    constexpr std::size_t least = 4, more_than_right = 2;  // rounding alone gives 1 or 2
    // The response has 6 times the noise's standard deviation, and its median absolute value is 0.6745 of
    // that.
    constexpr float median_of_unit = 6 * 0.6745f;
    const std::size_t median = median_response(wrong);
    if (median < least || median < more_than_right * median_response(right)) return 0;
    return static_cast<float>(median) / median_of_unit;
}

}  // namespace glint
