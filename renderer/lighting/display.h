#pragma once
// Linear colour -> what the screen shows: exposure, transfer, clamp, byte.
// sRGB: IEC 61966-2-1. Bytes: nearest of 256, halves up.

#include "renderer/lighting/light_job.h"
#include "renderer/simd/pow.h"
#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

/// sRGB encoding of linear x in 0..1.
template <Number F> F srgb_encoded(F x) {
    const F curve = F(1.055f) * power(x, F(1 / 2.4f)) - F(0.055f);
    return select(x <= F(0.0031308f), F(12.92f) * x, curve);
}

/// 0 to 1; NaN gives 0. The transfer keeps the order and the ends, so clamping first gives the same result.
template <Number F> F displayed(const DisplayJob& job, F linear) {
    const F exposed = min(max0(linear * F(job.exposure)), F(1));
    return job.srgb ? srgb_encoded(exposed) : exposed;
}

/// 0 to 255 from a displayed value in 0..1.
template <Number F> IntOf<F> byte_of(F shown) { return to_int(shown * F(255) + F(0.5f)); }

}  // namespace glint::inline GLINT_ISA
