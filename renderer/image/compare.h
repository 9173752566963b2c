#pragma once
// Measures the difference between two pictures as numbers, for tests and `glint compare`, and as a picture of
// the differences.

#include <array>
#include <cstdint>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

/// All values are displayed levels, 0 to 255; triples are red, green, blue.
struct Comparison {
    PictureSize size;
    std::array<int, 3> max{};      // largest difference in a pixel
    std::array<double, 3> mean{};  // mean absolute difference
    std::array<double, 3> rmse{};  // root mean square difference
    int alpha_max = 0;             // largest difference in opacity; 0 for two pictures rendered by Glint
    int max_error = 0;             // the largest of the maxima above
    std::uint64_t differing_pixels = 0;  // in any channel, including opacity
};

/// Compares two pictures pixel by pixel. Different sizes are a problem (without a file name).
[[nodiscard]] Result<Comparison> compare(const Picture& a, const Picture& b);

/// The multiplier of difference_picture(): the largest integer that keeps all differences within 255, so that
/// the smallest difference is visible and all can be recovered exactly. 1 if there are no differences.
[[nodiscard]] int difference_gain(const Comparison& comparison);

/// The absolute difference of every channel times `gain` (>= 1), at most 255. A difference in opacity
/// increases all three. With difference_gain(compare(a, b)) nothing is clamped. Precondition: equal sizes.
[[nodiscard]] Picture difference_picture(const Picture& a, const Picture& b, int gain);

}  // namespace glint
