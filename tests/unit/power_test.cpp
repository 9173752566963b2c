// power() against the library's pow in double, and the same bits in every width.
#include "renderer/lighting/power.h"

#include <cmath>
#include <random>

#include "tests/catch.h"

using namespace glint;

TEST_CASE("power is within 2.5e-6 of pow, relative, for results above 1e-6", "[power]") {
    std::mt19937 random(11);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const float x = static_cast<float>(random() % 1000001) * 1e-6f;
        const float s = static_cast<float>(random() % 100001) * 0.01f;
        const double exact = std::pow(static_cast<double>(x), static_cast<double>(s));
        if (exact < 1e-6) continue;  // smaller results lose a digit more and matter to no picture
        worst = std::max(worst, std::abs(power(x, s) / exact - 1));
    }
    CHECK(worst < 2.5e-6);
}

TEST_CASE("anything to the power 0 is 1, and 0 to any other power is 0", "[power]") {
    CHECK(power(0.0f, 0.0f) == 1.0f);
    CHECK(power(0.3f, 0.0f) == 1.0f);
    CHECK(power(0.0f, 0.5f) == 0.0f);
    CHECK(power(0.0f, 10000.0f) == 0.0f);
    CHECK(power(1e-40f, 2.0f) == 0.0f);
}

TEST_CASE("the peak of a highlight is exactly 1 at any shininess", "[power]") {
    for (float s = 0; s <= 10000; s += 7) CHECK(power(1.0f, s) == 1.0f);
}

TEMPLATE_TEST_CASE_SIG("lanes give the bits of float", "[power][lanes]", ((int N), N), 4, 8, 16) {
    std::mt19937 random(5);
    for (int round = 0; round < 2000; ++round) {
        float x[N], s[N], wide[N];
        for (int i = 0; i < N; ++i) {
            x[i] = static_cast<float>(random() % 1000001) * 1e-6f;
            s[i] = random() % 4 != 0 ? static_cast<float>(random() % 2000) * 0.25f : 0.0f;
        }
        store(wide, power(load<Lanes<N>>(x), load<Lanes<N>>(s)));
        for (int i = 0; i < N; ++i) REQUIRE(bits_of(wide[i]) == bits_of(power(x[i], s[i])));
    }
}
