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

/// What the mask (1 -2 1, -2 4 -2, 1 -2 1) gives at most: 16 times a channel's range.
constexpr std::size_t responses = 16 * 255 + 1;

/// The mask's amount in one channel at a pixel around which it is not of one colour; nothing where it is. The
/// mask answers 0 to levels that are linear or constant along rows or columns.
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

/// What the mask answers in one channel, pixel by pixel; no_answer at the border and in areas of one colour.
constexpr std::uint16_t no_answer = 0xFFFF;
std::vector<std::uint16_t> answers_of(const Picture& picture, std::size_t channel) {
    std::vector<std::uint16_t> answers(picture.size.pixels(), no_answer);
    for (int y = 1; y + 1 < picture.size.height; ++y)
        for (int x = 1; x + 1 < picture.size.width; ++x)
            if (const auto response = response_at(picture, x, y, channel))
                answers[picture.size.index(x, y)] = static_cast<std::uint16_t>(*response);
    return answers;
}

/// Returns the median of the mask's absolute responses over all channels. Only responses inside areas count,
/// not along lines: noise fills areas, but the mask also responds around edges between areas of one colour.
/// Returns 0 if fewer than one response in four is in an area.
std::size_t median_response(const Picture& picture) {
    constexpr int apart = 3;          // beyond the mask's own width
    constexpr std::size_t share = 4;  // of the answers; at least one in this many is in an area
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
    // The mask's answer has 6 times the deviation of the noise, and the median of its amount is 0.6745 of
    // that.
    constexpr float median_of_unit = 6 * 0.6745f;
    const std::size_t median = median_response(wrong);
    if (median < least || median < more_than_right * median_response(right)) return 0;
    return static_cast<float>(median) / median_of_unit;
}

}  // namespace glint
