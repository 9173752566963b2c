#pragma once
// Converts floating-point numbers of any value to integers: a cast of a value that does not fit is undefined.

#include <limits>

namespace glint {

/// Truncates `x`; a value beyond the range of int gives the nearest int, and NaN gives 0.
[[nodiscard]] constexpr int saturated_int(double x) {
    constexpr int low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
    if (!(x > low)) return x <= low ? low : 0;
    return x < high ? static_cast<int>(x) : high;
}

}  // namespace glint
