#pragma once
// Dispatches to the reflection models. To add a model, see docs/changing.md.

#include "models/scene/reflection.h"
#include "renderer/lighting/blinn_phong.h"
#include "renderer/lighting/cook_torrance.h"
#include "renderer/lighting/lambert.h"
#include "renderer/lighting/oren_nayar.h"
#include "renderer/lighting/phong.h"
#include "renderer/lighting/retro.h"

namespace glint::inline GLINT_ISA {

template <Number F>
Response<F> respond(Reflection model, const Directions<F>& d, const MaterialAt<F>& m, const PointAt<F>& at) {
    switch (model) {
    case Reflection::None:
        return {};
    case Reflection::Lambert:
        return lambert(d);
    case Reflection::Phong:
        return phong(d, m);
    case Reflection::BlinnPhong:
        return blinn_phong(d, m);
    case Reflection::Retro:
        return retro(d, m);
    case Reflection::OrenNayar:
        return oren_nayar(d, m, at);
    case Reflection::CookTorrance:
        return cook_torrance(d, m, at);
    }
    return {};  // unreachable
}

}  // namespace glint::inline GLINT_ISA
