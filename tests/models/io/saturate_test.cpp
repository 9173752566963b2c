// Floating point to int where anything may come in.
#include "models/saturate.h"

#include <cmath>
#include <limits>

#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("what does not fit an int becomes the nearest, NaN becomes 0, and fractions are dropped",
          "[saturate]") {
    constexpr int low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
    CHECK(saturated_int(2.9) == 2);
    CHECK(saturated_int(-2.9) == -2);
    CHECK(saturated_int(2147483646.9) == 2147483646);
    CHECK(saturated_int(2147483647.0) == high);
    CHECK(saturated_int(-2147483648.0) == low);
    CHECK(saturated_int(1e300) == high);
    CHECK(saturated_int(-3.4e38) == low);
    CHECK(saturated_int(HUGE_VAL) == high);
    CHECK(saturated_int(-HUGE_VAL) == low);
    CHECK(saturated_int(std::nan("")) == 0);
}
