// power() against the library's pow in double, and equal bits in every width.
#include <cmath>
#include <random>

#include "renderer/simd/pow.h"
#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("power is within a relative 2.5e-6 of pow for results above 1e-6", "[power]") {
    std::mt19937 random(11);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const float x = static_cast<float>(random() % 1000001) * 1e-6f;
        const float s = static_cast<float>(random() % 100001) * 0.01f;
        const double exact = std::pow(static_cast<double>(x), static_cast<double>(s));
        if (exact < 1e-6) continue;  // smaller results lose one more digit and are invisible
        worst = std::max(worst, std::abs(power(x, s) / exact - 1));
    }
    CHECK(worst < 2.5e-6);
}

TEST_CASE("squaring gives every whole power up to 1024 within 2^-24 of pow per factor", "[power]") {
    std::mt19937 random(3);
    for (int n = 0; n <= 1024; ++n) {
        const Exponent<float> s = static_cast<float>(n);
        REQUIRE(s.whole == n);
        for (int i = 0; i < 200; ++i) {
            // x such that x^n is spread from 2^-24, the smallest visible highlight, to 1
            const double wanted = std::exp2(-24.0 * static_cast<double>(random() % 1000001) * 1e-6);
            const auto x = static_cast<float>(std::pow(wanted, 1.0 / std::max(n, 1)));
            const double exact = std::pow(static_cast<double>(x), n);
            REQUIRE(power(x, s) == Approx(exact).epsilon(std::max(n, 1) * 0x1p-24).margin(0));
            const double of_root = std::pow(std::sqrt(static_cast<double>(x)), n);
            REQUIRE(power_of_root(x, s) == Approx(of_root).epsilon((n + 2) * 0x1p-25).margin(0));
        }
    }
}

TEST_CASE("fractional exponents and those above 1024 use polynomials that match squaring", "[power]") {
    for (const float s : {0.5f, 2.5f, 31.999998f, 1024.5f, 1025.0f, 10000.0f})
        CHECK(Exponent<float>(s).whole == -1);
    for (int n = 1; n <= 1024; ++n)
        for (const float wanted : {0.9f, 0.5f, 0.01f, 1e-6f}) {
            const auto s = static_cast<float>(n);
            const float x = std::pow(wanted, 1 / s);
            CHECK(power(x, Exponent<float>(s)) == Approx(power(x, s)).epsilon(4e-6 + n * 0x1p-24));
            Exponent<float> smooth(s);
            smooth.whole = -1;
            CHECK(power_of_root(x, Exponent<float>(s)) ==
                  Approx(power_of_root(x, smooth)).epsilon(4e-6 + n * 0x1p-24));
        }
}

TEST_CASE("a whole power of a negative number equals the same power of 0", "[power]") {
    CHECK(power(-0.5f, Exponent<float>(2.0f)) == 0.0f);
    CHECK(power(-0.5f, Exponent<float>(0.0f)) == 1.0f);
}

TEST_CASE("anything to the power 0 is 1, and 0 to any other power is 0", "[power]") {
    CHECK(power(0.0f, 0.0f) == 1.0f);
    CHECK(power(0.3f, 0.0f) == 1.0f);
    CHECK(power(0.0f, 0.5f) == 0.0f);
    CHECK(power(0.0f, 10000.0f) == 0.0f);
    CHECK(power(1e-40f, 2.0f) == 0.0f);
}

TEST_CASE("a power below the smallest float is 0, even for a huge exponent", "[power]") {
    for (const float s : {1e5f, 1e7f, 3e8f, 1e30f}) {
        CHECK(power(0.3f, s) == 0.0f);
        CHECK(power(1.2e-38f, s) == 0.0f);
    }
}

TEST_CASE("the peak of a highlight is exactly 1 at any shininess", "[power]") {
    for (float s = 0; s <= 10000; s += 7) CHECK(power(1.0f, s) == 1.0f);
}

TEMPLATE_TEST_CASE_SIG("lanes give the same bits as float", "[power][lanes]", ((int N), N), 4, 8, 16) {
    std::mt19937 random(5);
    for (int round = 0; round < 2000; ++round) {
        float x[N], s[N], wide[N];
        for (int i = 0; i < N; ++i) {
            x[i] = static_cast<float>(random() % 1000001) * 1e-6f;
            s[i] = random() % 4 != 0 ? static_cast<float>(random() % 2000) * 0.25f : 0.0f;
        }
        store(wide, power(load<Lanes<N>>(x), load<Lanes<N>>(s)));
        for (int i = 0; i < N; ++i) REQUIRE(bits_of(wide[i]) == bits_of(power(x[i], s[i])));
        const Exponent<Lanes<N>> same_s{Lanes<N>(s[0])};
        store(wide, power_of_root(load<Lanes<N>>(x), same_s));
        if (s[0] > 0)
            for (int i = 0; i < N; ++i)
                REQUIRE(bits_of(wide[i]) == bits_of(power_of_root(x[i], Exponent<float>(s[0]))));
    }
}
