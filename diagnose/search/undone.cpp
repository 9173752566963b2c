#include "diagnose/search/undone.h"

#include <cmath>

#include "diagnose/search/score.h"

namespace glint {
namespace {

/// For each byte of the wrong picture the one that was drawn.
std::array<std::uint8_t, 256> drawn_bytes(const DisplayChange& change) {
    const ByteRanges ranges = byte_ranges(change);
    std::array<std::uint8_t, 256> drawn{};
    for (std::size_t wrong = 0; wrong < drawn.size(); ++wrong) {
        const auto far = [&](std::size_t level) {
            return std::abs(ranges[level].middle - static_cast<float>(wrong));
        };
        std::size_t nearest = 0;
        for (std::size_t level = 1; level < ranges.size(); ++level)
            if (far(level) < far(nearest)) nearest = level;
        drawn[wrong] = static_cast<std::uint8_t>(nearest);
    }
    return drawn;
}

}  // namespace

Picture undone(const Picture& wrong, const DisplayChange& change) {
    const std::array<std::uint8_t, 256> drawn = drawn_bytes(change);
    Picture picture{wrong.size, std::vector<std::uint8_t>(wrong.rgba.size(), 255), {}};
    for (int y = 0; y < wrong.size.height; ++y)
        for (int x = 0; x < wrong.size.width; ++x) {
            const Rgb colour = mine_at(wrong, change, x, y);
            for (std::size_t c = 0; c < 3; ++c) picture.rgba[4 * wrong.pixel(x, y) + c] = drawn[colour[c]];
        }
    return picture;
}

}  // namespace glint
