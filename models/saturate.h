#pragma once
// Turns floating point into whole numbers where anything may come in: a cast of what does not fit is
// undefined.

#include <limits>

namespace glint {

/// `x` without its fraction; what lies beyond an int is its nearest one, and NaN is 0.
[[nodiscard]] constexpr int saturated_int(double x) {
    constexpr int low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
    if (!(x > low)) return x <= low ? low : 0;
    return x < high ? static_cast<int>(x) : high;
}

}  // namespace glint
