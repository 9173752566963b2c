#pragma once
// x^s for highlights, cones and sRGB: log2 and exp2 by polynomials, bit-identical for every width.
//
// log2(m) = (m - 1) P(m - 1) for m in [sqrt(1/2), sqrt(2)): no cancellation near 1, which is typical of
// highlights. exp2(f) = 1 + f Q(f) for f in [-1/2, 1/2]. Coefficients: Chebyshev interpolation with 30
// digits. Relative error below 4e-8 for P and 1e-8 for Q; 2.5e-6 for powers above 1e-6, because the product s
// log2(x) is rounded.

#include "renderer/simd/lanes.h"

namespace glint::inline GLINT_ISA {

inline constexpr int sqrt_half_bits = 0x3f3504f3;  // bits of the float nearest to sqrt(1/2)

/// log2(x) for normal x > 0, otherwise an unspecified finite number.
template <Number F> F log2_of(F x) {
    const IntOf<F> shifted = bits_of(x) - sqrt_half_bits;
    const F exponent = to_number(shifted >> 23);
    const F f = number_of_bits((shifted & 0x007fffff) + sqrt_half_bits) - F(1);
    // Adds pairs first (Estrin's scheme) to avoid one long chain of dependent products. Adds the two largest
    // terms last, so that only their rounding matters.
    const F f2 = f * f;
    const F a = (F(0.48091075f) + F(-0.36069328f) * f) + (F(0.28790325f) + F(-0.23916988f) * f) * f2;
    const F b = (F(0.21607822f) + F(-0.20586188f) * f) + F(0.12310968f) * f2;
    const F p = F(1.44269502f) + f * (F(-0.72134745f) + f * (a + b * (f2 * f2)));
    return exponent + f * p;
}

/// 2^y for y >= -126 (unspecified below), clamped to 2^127.
template <Number F> F exp2_above(F y) {
    const F held = min(y, F(127));
    // 1.5 * 2^23: adding it leaves the nearest integer in the low bits. The low nine bits of the constant are
    // zero.
    const F magic = F(12582912.0f);
    const F shifted = held + magic;
    const F f = held - (shifted - magic);
    const F f2 = f * f;
    const F q =
        (F(0.69314718f) + F(0.24022651f) * f) +
        f2 * ((F(0.05550357f) + F(0.009618083f) * f) + f2 * (F(0.0013390863f) + F(0.00015453163f) * f));
    const F scale = number_of_bits((bits_of(shifted) + 127) << 23);
    return scale * (F(1) + f * q);
}

/// 2^y; 0 below y = -126 (no denormals), clamped to 2^127.
template <Number F> F exp2_of(F y) { return select(y < F(-126), F(0), exp2_above(y)); }

/// x^s for x >= 0, s >= 0. Anything to the power 0 is 1 (including 0^0), 0 to any other power is 0. Negative
/// or NaN x is treated as 0.
template <Number F> F power(F x, F s) {
    const F usable = select(x >= F(smallest_normal), x, F(1));
    const F value = exp2_of(s * log2_of(usable));
    return select(x >= F(smallest_normal), value, select(s > F(0), F(0), F(1)));
}

/// Integer exponents up to this value use squaring, which takes a third of the work and is just as accurate.
inline constexpr float max_squared = 1024;

/// An exponent s >= 0, equal in all lanes.
template <Number F> struct Exponent {
    F value{};
    int whole = 0;  // the value if it is an integer up to `max_squared`, otherwise -1
    Exponent() = default;
    Exponent(F s) : value(s), whole(-1) {  // NOLINT: implicit, like Lanes(float)
        const float a = lane(s, 0);
        if (a >= 0 && a <= max_squared && a == static_cast<float>(static_cast<int>(a)))
            whole = static_cast<int>(a);
    }
};

/// x^n for n >= 0 by squaring, from the exponent's highest bit down. Relative error below n 2^-24.
template <Number F> F whole_power(F x, int n) {
    if (n == 0) return F(1);
    const int highest = 1 << (31 - __builtin_clz(static_cast<unsigned>(n)));
    F value = x;
    for (int bit = highest >> 1; bit != 0; bit >>= 1) {
        value = value * value;
        if (n & bit) value = value * x;
    }
    return value;
}

/// sqrt(x)^s for normal x > 0, at least 2^-126.
template <Number F> F power_of_root(F x, const Exponent<F>& s) {
    if (s.whole < 0) return exp2_above(max(s.value * (F(0.5f) * log2_of(x)), F(-126)));
    const F even = whole_power(x, s.whole / 2);
    return s.whole % 2 ? even * square_root(x) : even;
}

/// x^s for any x; negative x is treated as 0. 0^0 is 1.
template <Number F> F power(F x, const Exponent<F>& s) {
    return s.whole >= 0 ? whole_power(max0(x), s.whole) : power(x, s.value);
}

}  // namespace glint::inline GLINT_ISA
