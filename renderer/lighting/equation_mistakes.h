#pragma once
// The mistakes that change the equation itself (models/scene/mistakes.h), and the table of powers that early
// renderers used. They are separate from the equation itself: illuminate() applies them to its intermediate
// results, and only while a mistake or the table is enabled.

#include "models/scene/shading.h"
#include "renderer/lighting/light_job.h"
#include "renderer/lighting/reflection.h"

namespace glint::inline GLINT_ISA {

/// Changes the factors that do not depend on the surface: `falloff` at this distance, and `spot` for a unit
/// l.
template <Number F>
void apply_light_mistakes(const Mistakes& wrong, const LightAt<F>& light, F distance, Vec3<F> l, F& falloff,
                          F& spot) {
    if (wrong.falloff_inverted && light.has_falloff)
        falloff =
            min(falloff_polynomial(light.constant, light.linear, light.quadratic, distance), F(max_factor));
    if (wrong.light_direction_reversed && wrong.form == 1 && light.has_cone) spot = spot_factor(light, -l);
    if (wrong.unnormalized_light && (wrong.form & 1) != 0 && light.has_cone)
        spot = spot_factor(light, distance * l);
    if (wrong.cone_cosines_swapped && light.has_cone)
        spot = select(along_axis(light, l) >= light.cos_cutoff, F(0), F(1));
}

/// Changes the vector to a lamp, its length, or the distance that the falloff uses.
template <Number F>
void apply_vector_mistakes(const Mistakes& wrong, const LightAt<F>& light, const PointAt<F>& at,
                           LightVector<F>& towards, Attenuation<F>& reach) {
    if (!is_positional(light) || light.is_patch) return;
    const auto fall_off = [&](F distance) {
        if (light.has_falloff) reach.falloff = falloff(light, distance);
    };
    if (wrong.position_is_direction) {
        const Vec3<F> given = (wrong.form & 1) != 0 ? light.xyz : light.as_direction;
        const F size = length(given), distance = (wrong.form & 2) != 0 ? size : reach.distance;
        towards.xyz = (distance * inverse_or_zero(size)) * given;
        reach = {distance, inverse_or_zero(distance), reach.falloff};
        fall_off(distance);
    }
    if (wrong.light_direction_reversed && wrong.form > 0) towards.xyz = -towards.xyz;
    if (wrong.distance_includes_w) {
        const F distance = square_root(dot(towards.xyz, towards.xyz) + F(1));
        reach = {distance, F(1) / distance, reach.falloff};
        fall_off(distance);
    }
    if (wrong.divided_by_square) {
        reach.inverse = reach.inverse * reach.inverse;
        reach.distance = reach.distance * reach.distance;
    }
    if (wrong.distance_across_spaces) fall_off(length(light.as_given - at.p));
    towards.n_dot = dot(at.n, towards.xyz);
}

/// Keeps the length of l in n.l, r and h (not in l.v, cone and falloff), keeps h unnormalized, or changes r.
template <Number F>
void apply_direction_mistakes(const Mistakes& wrong, Reflection model, Directions<F>& d,
                              const LightVector<F>& light_vector, const PointAt<F>& at) {
    if (wrong.unnormalized_light) {
        // l.v uses a unit l, but a directional light's vector is not normalized here.
        const F inverse = inverse_or_zero(square_root(dot(light_vector.xyz, light_vector.xyz)));
        const F l_dot_v = inverse * dot(light_vector.xyz, at.v);
        d = directions_for(light_vector, Attenuation<F>{}, at);
        d.l_dot_v = l_dot_v;
    }
    if (wrong.unnormalized_half) {  // half of l + v, or l + v itself, of any length
        d.h = F(wrong.form == 1 ? 1.0f : 0.5f) * (d.l + at.v);
        d.n_dot_h = dot(at.n, d.h);
        d.n_dot_unnormalized_h = d.n_dot_h;
        d.unnormalized_h_squared = F(1);
    }
    if (info_of(model).cosine != HighlightCosine::RV) return;
    if (wrong.reflect_of_difference) {
        d.r = (d.n_dot_l + d.n_dot_l) * (at.n - d.l);
        d.r_dot_v = dot(d.r, at.v);
    }
    if (wrong.reflect_sign) {
        d.r = -d.r;
        d.r_dot_v = -d.r_dot_v;
    }
}

/// x^s for any sign of x, as in code without the clamp: an even function of x for an even or fractional s, an
/// odd one for an odd s.
template <Number F> F unclamped_power(F x, F s) {
    const F half = s * F(0.5f), magic = F(8388608.0f);
    const F nearest = (half + magic) - magic, rest = abs(s - (nearest + nearest));
    const F value = power(abs(x), s);
    return select(mask_and(x < F(0), rest >= F(1)), -value, value);
}

/// Rounds the cosine to the nearest of `entries` values, evenly spaced from 0 to 1. A table of powers stores
/// their powers, so a lookup is the same as rounding the cosine.
template <Number F> F nearest_entry(F cosine, int entries) {
    const F last = F(static_cast<float>(entries - 1)), magic = F(8388608.0f);
    return ((min(max0(cosine), F(1)) * last + magic) - magic) / last;
}

/// c^shininess for c that may exceed 1, such as the dot product of vectors that are not normalized.
template <Number F> F unheld_highlight(F c, const MaterialAt<F>& m) {
    const F squared = max(c * c, m.min_cosine_squared), most = F(0x1p127f);
    const F power = min(power_of_root(min(squared, most), m.shininess), most);
    return select(c * abs(c) > m.min_cosine_squared, power, F(0));
}

/// The cosine that a program with these mistakes raises to the shininess.
inline HighlightCosine measured_cosine(const Mistakes& wrong, Reflection model) {
    const bool half = wrong.half_angle_with_phong_shininess && model == Reflection::Phong;
    return half ? HighlightCosine::NH : info_of(model).cosine;
}
template <Number F> F cosine_of(HighlightCosine measured, const Directions<F>& d) {
    switch (measured) {
    case HighlightCosine::None:
        break;
    case HighlightCosine::RV:
        return d.r_dot_v;
    case HighlightCosine::NH:
        return d.n_dot_h;
    case HighlightCosine::LV:
        return d.l_dot_v;
    }
    return F(0);
}

/// The n.l that the highlight's test uses.
template <Number F> F tested_cosine(const Mistakes& wrong, const Directions<F>& d) {
    return wrong.absolute_cosine ? abs(d.n_dot_l) : d.n_dot_l;
}
template <Number F> Vec3<F> keep_lit_side(const Mistakes& wrong, const Directions<F>& d, Vec3<F> specular) {
    if (wrong.specular_behind_surface) return specular;
    return select<F>(tested_cosine(wrong, d) > F(0), specular, Vec3<F>{});
}

/// The factor of the diffuse term.
template <Number F>
void apply_diffuse_mistakes(const Mistakes& wrong, Reflection model, F& diffuse, const Directions<F>& d,
                            const MaterialAt<F>& m, const PointAt<F>& at) {
    const ReflectionInfo info = info_of(model);
    if (wrong.no_clamp_of_cosine && info.is_lit && !info.rough_diffuse) diffuse = d.n_dot_l;
    if (wrong.absolute_cosine && info.is_lit) {
        diffuse = abs(d.n_dot_l);
        if (info.rough_diffuse) diffuse = diffuse * roughness_factor(d, m, at);
    }
    if (wrong.half_lambert && info.is_lit) {
        diffuse = max0(F(0.5f) + F(0.5f) * d.n_dot_l);
        if (wrong.form == 1) diffuse = diffuse * diffuse;
    }
    if (wrong.missing_pi) diffuse = diffuse / F(3.14159265f);
}

/// Whether mistakes let the cosine exceed 1, which highlight() does not expect.
inline bool may_exceed_one(const Mistakes& wrong, HighlightCosine measured) {
    if (wrong.unnormalized_normals && wrong.form == 0) return true;
    if (measured == HighlightCosine::NH) return wrong.unnormalized_half && wrong.form == 1;
    if (measured == HighlightCosine::LV) return wrong.unnormalized_view || wrong.divided_by_square;
    return measured == HighlightCosine::RV && (wrong.unnormalized_light || wrong.unnormalized_view ||
                                               wrong.reflect_of_difference || wrong.divided_by_square);
}

/// Applies the mistakes in the factors of the highlight.
template <Number F>
void apply_highlight_mistakes(const Mistakes& wrong, Reflection model, Vec3<F>& specular,
                              const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    const auto fresnel = [](Vec3<F> f0, F c) -> Vec3<F> {
        return {f_schlick(f0.x, c), f_schlick(f0.y, c), f_schlick(f0.z, c)};
    };
    if (wrong.highlight_normalized && wrong.highlight_form == 3) {  // uses k_s as Fresnel's f0
        const Vec3<F> f = fresnel(m.k_s, max0(dot(at.v, d.h)));
        specular = max0(d.n_dot_l) * (specular * f);
        specular = {specular.x * inverse_or_zero(m.k_s.x), specular.y * inverse_or_zero(m.k_s.y),
                    specular.z * inverse_or_zero(m.k_s.z)};
    }
    if (model != Reflection::CookTorrance) return;
    if (wrong.specular_without_cosine) specular = inverse_or_zero(max0(d.n_dot_l)) * specular;
    if (wrong.fresnel_of_view_angle) {
        const Vec3<F> is = fresnel(m.f0, max0(dot(at.v, d.h)));
        specular = specular * fresnel(m.f0, max0(at.n_dot_v));
        specular = {specular.x * inverse_or_zero(is.x), specular.y * inverse_or_zero(is.y),
                    specular.z * inverse_or_zero(is.z)};
    }
}

template <Number F>
void apply_response_mistakes(const Mistakes& wrong, int power_table, Reflection model, Response<F>& used,
                             const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    apply_diffuse_mistakes(wrong, model, used.diffuse, d, m, at);
    const HighlightCosine measured = measured_cosine(wrong, model);
    Directions<F> tested = d;
    tested.n_dot_l = tested_cosine(wrong, d);
    const Reflection formula = measured == info_of(model).cosine ? model : Reflection::BlinnPhong;
    used.specular = keep_lit_side(wrong, d, respond(formula, tested, m, at).specular);
    if (measured == HighlightCosine::None)
        return apply_highlight_mistakes(wrong, model, used.specular, d, m, at);
    const F cosine = cosine_of(measured, d);
    if (wrong.no_clamp_of_cosine) {
        const F s = unclamped_power(cosine, m.shininess.value);
        used.specular = {s, s, s};
    } else if (power_table > 0) {
        const F s = highlight(nearest_entry(cosine, power_table), m);
        used.specular = keep_lit_side(wrong, d, {s, s, s});
    } else if (may_exceed_one(wrong, measured)) {
        const F s = unheld_highlight(cosine, m);
        const Vec3<F> unclamped = keep_lit_side(wrong, d, {s, s, s});
        // Where all normals are unit vectors, their lengths have no effect, so the bits must not change.
        constexpr float unit = 1.00001f;
        used.specular =
            wrong.unnormalized_normals ? select<F>(cosine > F(unit), unclamped, used.specular) : unclamped;
    }
    apply_highlight_mistakes(wrong, model, used.specular, d, m, at);
}

/// Makes every term NaN if the normal is NaN, because comparisons and max() would discard the NaN.
template <Number F>
void apply_undefined_normal(const PointAt<F>& at, Vec3<F>& ambient, Vec3<F>& diffuse, Vec3<F>& specular) {
    const auto defined = dot(at.n, at.n) >= F(0);
    const F nan(__builtin_nanf(""));
    for (Vec3<F>* term : {&ambient, &diffuse, &specular})
        *term = select<F>(defined, *term, Vec3<F>{nan, nan, nan});
}

/// pow(0, 0) and powers of negative numbers, which GLSL leaves undefined: where the highlight is not dropped
/// and either its clamped cosine and the shininess are both 0 or its cosine is negative, S and everything
/// computed from it are NaN, or shown white.
template <Number F>
void apply_undefined_powers(const Mistakes& wrong, Reflection model, const Directions<F>& d,
                            const MaterialAt<F>& m, Vec3<F>& response, Vec3<F>* specular) {
    const HighlightCosine measured = measured_cosine(wrong, model);
    const bool of_zero = wrong.power_zero_is_nan && lane(m.shininess.value, 0) == 0;
    if (!(of_zero || wrong.power_of_negative_is_nan) || measured == HighlightCosine::None) return;
    const F tested = wrong.specular_behind_surface ? F(1) : tested_cosine(wrong, d);
    const F cosine = cosine_of(measured, d);
    const F least = of_zero ? F(0) : F(-smallest_normal);
    const auto undefined = mask_and(tested > F(0), least >= cosine);
    const F nan = F(wrong.form == 1 && !of_zero ? 1e6f : __builtin_nanf(""));
    const Vec3<F> none{nan, nan, nan};
    response = select<F>(undefined, none, response);
    if (specular) *specular = select<F>(undefined, none, *specular);
}

/// Clamps a to +-most.
template <Number F> F held(F a, F most) { return min(max(a, -most), most); }

/// The projected point, which replaces the point in camera coordinates; the origin for a point at the eye,
/// which has no projection. Matrix and point must be within +-1e18, and so is the result.
template <Number F> Vec3<F> projected(const LightJob::Projection& m, Vec3<F> p) {
    const F far = F(1e18f);
    const F w = F(m.w_per_z) * p.z + F(m.w);
    const F inverse = select(abs(w) >= F(smallest_normal), F(1) / w, F(0));
    return {held((F(m.x) * p.x + F(m.x_per_z) * p.z + F(m.x_plus)) * inverse, far),
            held((F(m.y) * p.y + F(m.y_per_z) * p.z + F(m.y_plus)) * inverse, far),
            held((F(m.z) * p.z + F(m.z_plus)) * inverse, far)};
}

/// The point, its normal and its direction to the eye, with the viewer mistakes applied.
template <Number F> PointAt<F> mistakenly_seen(const LightJob& job, Vec3<F> p, Vec3<F> n) {
    const Mistakes& wrong = job.mistakes;
    if (wrong.lit_after_projection) p = projected(job.projection, p);
    const Vec3<F> to_eye = broadcast<F>(job.eye) - p;
    Vec3<F> v = wrong.unnormalized_view ? to_eye : unit(to_eye);
    if (wrong.divided_by_square && wrong.form == 1) v = inverse_or_zero(dot(to_eye, to_eye)) * to_eye;
    if (job.infinite_viewer) v = {F(0), F(0), F(1)};
    if (wrong.view_reversed) v = -v;
    if (wrong.flipped_by_view) n = select<F>(dot(n, v) < F(0), -n, n);
    return PointAt<F>(p, n, v);
}

}  // namespace glint::inline GLINT_ISA
