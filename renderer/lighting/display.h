#pragma once
// Converts linear colours to displayed colours: exposure, transfer, clamp, byte. sRGB: IEC 61966-2-1. Bytes
// are rounded to the nearest of 256 levels, halves up.

#include "renderer/lighting/light_job.h"
#include "renderer/simd/pow.h"
#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

/// sRGB encoding of linear x in 0..1.
template <Number F> F srgb_encoded(F x) {
    const F curve = F(1.055f) * power(x, F(1 / 2.4f)) - F(0.055f);
    const F encoded = select(x <= F(0.0031308f), F(12.92f) * x, curve);
    // The curve does not reach exactly 1 because its two constants are rounded.
    return select(mask_and(x >= F(1), x <= F(1)), x, encoded);
}

/// Returns a value from 0 to 1; NaN gives 0. The transfer function is monotonic and leaves 0 and 1 unchanged,
/// so clamping first gives the same result.
template <Number F> F displayed(const DisplayJob& job, F linear) {
    const F exposed = min(max0(linear * F(job.exposure)), F(1));
    return job.srgb ? srgb_encoded(exposed) : exposed;
}

/// Converts a displayed value in 0..1 to 0..255.
template <Number F> IntOf<F> byte_of(F shown) { return to_int(shown * F(255) + F(0.5f)); }

/// The displayed value with display mistakes: encoded twice or not clamped. NaN and infinity give 0.
template <Number F> F mistakenly_displayed(const DisplayJob& job, F linear) {
    const F exposed = linear * F(job.exposure);
    F shown = min(max0(exposed), F(1));
    if (job.wraps) shown = select(abs(exposed) < F(0x1p120f), exposed, F(0));
    if (job.srgb) shown = srgb_encoded(shown);
    return job.encoded_twice ? srgb_encoded(shown) : shown;
}

/// The largest integer not above a. Precondition: |a| < 2^31, or a is an integer.
template <Number F> F floor_of(F a) {
    const auto has_fraction = abs(a) < F(0x1p23f);
    const F whole = to_number(to_int(select(has_fraction, a, F(0))));
    const F below = whole - select(whole > a, F(1), F(0));
    return select(has_fraction, below, a);
}

/// Converts a value of any size to a byte modulo 256.
template <Number F> IntOf<F> wrapped_byte_of(F shown) {
    const F whole = floor_of(shown * F(255) + F(0.5f));
    const F rest = whole - F(256) * floor_of(whole * F(1 / 256.0f));
    return to_int(select(abs(whole) < F(0x1p120f), rest, F(0)));
}

}  // namespace glint::inline GLINT_ISA
