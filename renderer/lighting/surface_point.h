#pragma once
// A point to be lit, and what its surface is made of.

#include "renderer/lighting/power.h"
#include "renderer/lighting/vec3.h"

namespace glint::inline GLINT_ISA {

/// Camera coordinates. n and v unit (n may be zero where nothing defines it); v points towards the eye.
template <Number F> struct PointAt { Vec3<F> p, n, v; };

template <Number F> struct MaterialAt {
    Vec3<F> k_a, k_d, k_s;  // linear RGB
    F shininess{};
    F faintest{-1};  // cosines up to this one give a highlight below 2^-24, which counts as none
    F roughness{};   // 0 to 1
    Vec3<F> f0;      // reflectance at normal incidence
};

/// What a reflection model makes of one light: the factors of the diffuse and of the specular term.
template <Number F> struct Response {
    F diffuse{};
    Vec3<F> specular;  // S, per channel; the caller drops it where the light is behind the surface
};

/// The vectors and cosines that every model is written in. l, r, h unit, camera coordinates.
template <Number F> struct Directions {
    Vec3<F> l, r, h;  // towards the light; l mirrored at n; halfway between l and v (0 when l = -v)
    F n_dot_l{};      // not clamped
};

/// r and h for a light in direction l. Lecture: "Calculating R Vector", "Blinn-Phong Model".
template <Number F> Directions<F> directions_for(Vec3<F> l, const PointAt<F>& at) {
    Directions<F> d;
    d.l = l;
    d.n_dot_l = dot(at.n, l);
    d.r = (d.n_dot_l + d.n_dot_l) * at.n - l;  // 2 n (n.l) - l
    d.h = unit(l + at.v);
    return d;
}

/// cosine^shininess for a cosine of any sign; 0 where it is not above `faintest`, which most of a picture is.
template <Number F> F highlight(F cosine, const MaterialAt<F>& m) {
    const auto seen = cosine > m.faintest;
    if (!any(seen)) return F(0);
    return select(seen, power(positive(cosine), m.shininess), F(0));
}

}  // namespace glint::inline GLINT_ISA
