#pragma once
// Changes to a picture that are not lighting mistakes: it was flipped, its channels were swapped, or its
// colours were brightened or encoded. A diagnosis detects and undoes these before it looks for mistakes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>

#include "renderer/picture.h"
#include "renderer/simd/lanes.h"

namespace glint {

/// Many programs encode with the power 1 / 2.2 instead of sRGB's curve.
inline constexpr double encoding_power = 2.2;

/// A curve applied to the displayed numbers: none, sRGB's (IEC 61966-2-1) from linear to encoded, its
/// inverse, or the power 1 / encoding_power.
enum class Code { Same, Encoded, Decoded, Power };

struct DisplayChange {
    bool upside_down = false, mirrored = false, red_blue = false;
    // A channel c from 0 to 1 became after(gain * before(c)), clamped; `before` is not Power.
    Code before = Code::Same, after = Code::Same;
    float gain = 1;
    /// Pixels may show anything between their neighbours: edges are smoothed, or everything is shifted by up
    /// to a pixel.
    bool soft = false;
    /// The standard deviation, in levels, of every pixel's random error.
    float noise = 0;
    bool operator==(const DisplayChange&) const = default;

    /// The picture's number of excess encodings: -1, 0 or 1.
    [[nodiscard]] int encodings() const;
    [[nodiscard]] bool is_by_power() const { return after == Code::Power; }
    /// The number of changes; a gain outside 1/3 to 3 counts twice. Noise is measured, not assumed.
    [[nodiscard]] int count() const;
    /// How far noise may change a pixel, in levels: four standard deviations, which one in 16,000 pixels
    /// exceeds.
    [[nodiscard]] float scatter() const { return 4 * noise; }
};

/// The index of the way in which a picture is flipped, 0 to 3, and a change for each.
[[nodiscard]] inline std::size_t way_turned(const DisplayChange& change) {
    return (change.upside_down ? 2U : 0U) + (change.mirrored ? 1U : 0U);
}
[[nodiscard]] std::array<DisplayChange, 4> ways_of_turning();
/// The position of a pixel of the scene's picture in the changed picture of that size, and its index there.
[[nodiscard]] glm::ivec2 changed_place(const DisplayChange& change, PictureSize size, glm::ivec2 pixel);
[[nodiscard]] std::size_t changed_index(const DisplayChange& change, PictureSize size, int x, int y);
/// Whether two changes differ only in gain, softness and noise, or not at all.
[[nodiscard]] bool are_of_one_display(const DisplayChange& a, const DisplayChange& b);
/// The channel of the changed picture to which a channel was moved.
[[nodiscard]] inline std::size_t changed_channel(const DisplayChange& change, std::size_t channel) {
    return change.red_blue ? 2 - channel : channel;
}
/// Converts three channels, or one value for each, from one picture's channel order to the other's.
template <class T>
[[nodiscard]] std::array<T, 3> exchanged(const DisplayChange& change, const std::array<T, 3>& colour) {
    return {colour[changed_channel(change, 0)], colour[1], colour[changed_channel(change, 2)]};
}

/// How far `level` is outside the range `low` to `high`.
template <Number F> [[nodiscard]] F levels_outside(F low, F high, F level) {
    return max0(max(low - level, level - high));
}

/// What a byte of the scene's picture may have become, in levels from 0 to 255 with fractions: rounding and
/// clamping leave a range.
struct ByteRange {
    float low = 0, middle = 0, high = 0;
    bool is_clamped = false;  // it was drawn as 255: anything from `middle` on may have been clamped to that

    [[nodiscard]] float distance(std::uint8_t byte) const {
        return levels_outside(low, high, static_cast<float>(byte));
    }
    [[nodiscard]] float from_middle(std::uint8_t byte) const {
        return std::abs(middle - static_cast<float>(byte));
    }
    /// How far the drawn level itself is from `byte`, ignoring the range for noise and softness.
    [[nodiscard]] float off(std::uint8_t byte) const {
        return is_clamped && static_cast<float>(byte) > middle ? 0 : from_middle(byte);
    }
};
using ByteRanges = std::array<ByteRange, 256>;
[[nodiscard]] ByteRanges byte_ranges(const DisplayChange& change);

/// Both ends of byte_ranges() without the middle, which costs as much to compute as the two ends.
struct ByteBounds {
    std::array<float, 256> low{}, high{};
};
[[nodiscard]] ByteBounds byte_bounds(const DisplayChange& change);

/// The curve of one code, for x from 0 to 1.
[[nodiscard]] float coded(Code code, float x);
/// The same for byte / 255, from a table. Precondition: the code is not Power.
[[nodiscard]] float coded_byte(Code code, std::uint8_t byte);

// Pictures as submitted: perhaps screenshots of a window, with a border or with each pixel enlarged to a
// square.

struct ArrivedPicture {
    Picture picture;
    std::string words;  // what was undone; empty if nothing was
};

/// Returns the bytes of the picture without a border or letterbox of one colour, and with each square of k x
/// k equal pixels, k up to 4, as one pixel. A border is kept if the scene's own picture has one: then it is
/// the background around an object.
[[nodiscard]] ArrivedPicture as_arrived(Picture picture, const Scene& scene);

/// The bytes of a picture at a different size; each pixel is a copy of the nearest one, and nothing is
/// blended.
[[nodiscard]] inline Picture resampled(const Picture& picture, PictureSize size) {
    if (picture.size == size) return picture;
    Picture other{size, std::vector<std::uint8_t>(4 * size.pixels()), {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int from_x = (2 * x + 1) * picture.size.width / (2 * size.width);
            const int from_y = (2 * y + 1) * picture.size.height / (2 * size.height);
            std::copy_n(&picture.rgba[4 * picture.pixel(from_x, from_y)], 4,
                        &other.rgba[4 * size.index(x, y)]);
        }
    return other;
}

}  // namespace glint
