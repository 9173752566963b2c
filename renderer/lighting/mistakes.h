#pragma once
// The mistakes that change the equation itself (models/scene/mistakes.h), and the table of powers that
// renderers once looked up. They stand apart from the equation's own text: illuminate() calls them on its
// intermediate results, and only while a mistake or the table is on.

#include "models/scene/shading.h"
#include "renderer/lighting/light_job.h"
#include "renderer/lighting/reflection.h"

namespace glint::inline GLINT_ISA {

/// l keeps its length in n.l, r and h (not in l.v, cone and falloff), or h is not made unit.
template <Number F>
void apply_direction_mistakes(const Mistakes& wrong, Directions<F>& d, const LightVector<F>& light_vector,
                              const PointAt<F>& at) {
    if (wrong.unnormalized_light) {
        const F l_dot_v = d.l_dot_v;
        d = directions_for(light_vector, Attenuation<F>{}, at);
        d.l_dot_v = l_dot_v;
    }
    if (wrong.unnormalized_half) {  // half of l + v, whatever its length
        d.h = F(0.5f) * (d.l + at.v);
        d.n_dot_h = dot(at.n, d.h);
        d.n_dot_unnormalized_h = d.n_dot_h;
        d.unnormalized_h_squared = F(1);
    }
}

/// x^s for any sign of x, as code without the clamp gives it: even for an even s, odd for an odd one; a
/// fraction counts as even.
template <Number F> F unclamped_power(F x, F s) {
    const F half = s * F(0.5f), magic = F(8388608.0f);
    const F nearest = (half + magic) - magic, rest = abs(s - (nearest + nearest));
    const F value = power(abs(x), s);
    return select(mask_and(x < F(0), rest >= F(1)), -value, value);
}

/// The cosine of the nearest of `entries` entries, evenly from 0 to 1: a table of powers holds the powers of
/// these, so that looking up is the same as rounding the cosine.
template <Number F> F nearest_entry(F cosine, int entries) {
    const F last = F(static_cast<float>(entries - 1)), magic = F(8388608.0f);
    return ((min(max0(cosine), F(1)) * last + magic) - magic) / last;
}

/// c^shininess for c that may exceed 1, as the dot product of vectors that are not unit does.
template <Number F> F unheld_highlight(F c, const MaterialAt<F>& m) {
    const F squared = max(c * c, m.faintest_squared), most = F(0x1p127f);
    const F power = min(power_of_root(min(squared, most), m.shininess), most);
    return select(c * abs(c) > m.faintest_squared, power, F(0));
}

template <Number F>
void apply_response_mistakes(const Mistakes& wrong, int power_table, Reflection model, Response<F>& used,
                             const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const auto keep_side = [&](Vec3<F> specular) {
        return wrong.specular_behind_surface ? specular : select<F>(d.n_dot_l > F(0), specular, Vec3<F>{});
    };
    if (wrong.specular_behind_surface) used.specular = respond(model, d, m, at).specular;
    HighlightCosine measured = info_of(model).cosine;
    if (wrong.half_angle_with_phong_shininess && model == Reflection::Phong) {
        measured = HighlightCosine::NH;
        used.specular = keep_side(blinn_phong(d, m).specular);
    }
    if (!wrong.no_clamp_of_cosine && !wrong.unnormalized_light && power_table == 0) return;
    if (wrong.no_clamp_of_cosine && info_of(model).is_lit && !info_of(model).rough_diffuse)
        used.diffuse = d.n_dot_l;
    F cosine{};
    switch (measured) {
    case HighlightCosine::None:
        return;
    case HighlightCosine::RV:
        cosine = d.r_dot_v;
        break;
    case HighlightCosine::NH:
        cosine = d.n_dot_h;
        break;
    case HighlightCosine::LV:
        cosine = d.l_dot_v;
        break;
    }
    if (wrong.no_clamp_of_cosine) {
        const F s = unclamped_power(cosine, m.shininess.value);
        used.specular = {s, s, s};
    } else if (power_table == 0) {
        const F s = unheld_highlight(cosine, m);
        used.specular = keep_side({s, s, s});
    } else {
        const F s = highlight(nearest_entry(cosine, power_table), m);
        used.specular = keep_side({s, s, s});
    }
}

/// The number nearest to a within +-most.
template <Number F> F held(F a, float most) { return min(max(a, F(-most)), F(most)); }
/// Keeps the product of falloff and response finite, so that it times a colour of 0 is 0 and not NaN.
template <Number F> F held_share(F a) { return held(a, 0x1p120f); }

/// The point as the projection leaves it, in place of the point in camera coordinates; at the eye, where
/// there is none, the origin. Matrix and point within +-1e18, and so is the result.
template <Number F> Vec3<F> projected(const LightJob::Projection& m, Vec3<F> p) {
    constexpr float far = 1e18f;
    const F w = F(m.w_per_z) * p.z + F(m.w);
    const F inverse = select(abs(w) >= F(smallest_normal), F(1) / w, F(0));
    return {held((F(m.x) * p.x + F(m.x_per_z) * p.z + F(m.x_plus)) * inverse, far),
            held((F(m.y) * p.y + F(m.y_per_z) * p.z + F(m.y_plus)) * inverse, far),
            held((F(m.z) * p.z + F(m.z_plus)) * inverse, far)};
}

}  // namespace glint::inline GLINT_ISA
