#pragma once
// Measures the difference of two pictures: numbers for tests and for `glint compare`, and a picture of the
// differences.

#include <array>
#include <cstdint>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

/// All in displayed levels, 0 to 255; three numbers are red, green, blue.
struct Comparison {
    PictureSize size;
    std::array<int, 3> max{};            // largest difference of a pixel
    std::array<double, 3> mean{};        // of the differences' absolute values
    std::array<double, 3> rmse{};        // root of the mean of their squares
    int alpha_max = 0;                   // largest difference in opacity; 0 between pictures of Glint
    int max_error = 0;                   // the largest of the above
    std::uint64_t differing_pixels = 0;  // in any channel, opacity included
};

/// Compares two pictures pixel by pixel. Different sizes are a problem, without a file.
[[nodiscard]] Result<Comparison> compare(const Picture& a, const Picture& b);

/// The factor for differences in difference_picture(): the largest integer that keeps all within 255, so that
/// the smallest difference is visible and all can be read exactly. 1 if there are none.
[[nodiscard]] int difference_gain(const Comparison& comparison);

/// The absolute difference of every channel times `gain` (>= 1), at most 255; a difference in opacity raises
/// all three. With difference_gain(compare(a, b)) nothing is clamped. Precondition: equal sizes.
[[nodiscard]] Picture difference_picture(const Picture& a, const Picture& b, int gain);

}  // namespace glint
