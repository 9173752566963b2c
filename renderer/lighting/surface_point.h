#pragma once
// A point to be lit, and what its surface is made of.

#include "renderer/lighting/power.h"
#include "renderer/lighting/vec3.h"

namespace glint::inline GLINT_ISA {

/// Camera coordinates. n and v unit (n may be zero where nothing defines it); v points towards the eye.
template <Number F> struct PointAt {
    Vec3<F> p, n, v;
    F n_dot_v{};
    PointAt() = default;
    PointAt(Vec3<F> place, Vec3<F> normal, Vec3<F> to_eye)
        : p(place), n(normal), v(to_eye), n_dot_v(dot(normal, to_eye)) {}
};

template <Number F> struct MaterialAt {
    Vec3<F> k_a, k_d, k_s;  // linear RGB
    F shininess{};
    F faintest_squared{};  // cosines whose squares, with their signs, are not above this give no highlight
    F roughness{};         // 0 to 1
    Vec3<F> f0;            // reflectance at normal incidence
};

/// What a reflection model makes of one light: the factors of the diffuse and of the specular term.
template <Number F> struct Response {
    F diffuse{};
    Vec3<F> specular;  // S, per channel; the caller drops it where the light is behind the surface
};

/// The vectors and cosines that every model is written in. l, r, h unit, camera coordinates. What a model
/// does not use is never computed: the compiler leaves it out.
template <Number F> struct Directions {
    Vec3<F> l, r, h;  // towards the light; l mirrored at n; halfway between l and v (0 when l = -v)
    F n_dot_l{}, r_dot_v{}, n_dot_h{};       // not clamped
    F n_dot_l_plus_v{}, l_plus_v_squared{};  // n.h before h is made unit, and what that divides by, squared
};

/// From a point to a light, not unit (of a directional light the unit direction itself), and its product with
/// n.
template <Number F> struct ToLight {
    Vec3<F> xyz;
    F n_dot{};
};

/// All of them for l = scale * to_light. Lecture: "Calculating R Vector", "Blinn-Phong Model".
/// r.v = (2 n (n.l) - l).v = 2 (n.l)(n.v) - l.v, and n.h = n.(l + v) / |l + v|.
template <Number F> Directions<F> directions_for(const ToLight<F>& to_light, F scale, const PointAt<F>& at) {
    Directions<F> d;
    d.l = scale * to_light.xyz;
    d.n_dot_l = scale * to_light.n_dot;
    const F twice = d.n_dot_l + d.n_dot_l;
    d.r = twice * at.n - d.l;
    d.r_dot_v = twice * at.n_dot_v - dot(d.l, at.v);
    const Vec3<F> l_plus_v = d.l + at.v;
    d.n_dot_l_plus_v = d.n_dot_l + at.n_dot_v;
    d.l_plus_v_squared = dot(l_plus_v, l_plus_v);
    const F inverse = inverse_or_zero(square_root(d.l_plus_v_squared));
    d.h = inverse * l_plus_v;
    d.n_dot_h = inverse * d.n_dot_l_plus_v;
    return d;
}

/// The same for a unit l.
template <Number F> Directions<F> directions_for(Vec3<F> l, const PointAt<F>& at) {
    return directions_for(ToLight<F>{l, dot(at.n, l)}, F(1), at);
}

/// c^shininess for the cosine c = scaled / length, of any sign, as (c^2)^(shininess / 2), so that no root has
/// to be drawn for the length. 0 where c^2, with c's sign, is not above `faintest_squared`, as over much of a
/// picture.
template <Number F> F highlight(F scaled, F length_squared, const MaterialAt<F>& m) {
    const F squared = larger(length_squared, F(smallest_normal));
    const auto seen = scaled * magnitude(scaled) > m.faintest_squared * squared;
    if (!any(seen)) return F(0);
    const F y = m.shininess * (F(0.5f) * log2_of(scaled * scaled / squared));
    return select(seen, exp2_above(larger(y, F(-126))), F(0));
}
template <Number F> F highlight(F cosine, const MaterialAt<F>& m) { return highlight(cosine, F(1), m); }

}  // namespace glint::inline GLINT_ISA
