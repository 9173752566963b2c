#pragma once
// A reflection model's formula (ReflectionInfo::program) as a program writes it. In the row it stands once,
// as statements that C++, GLSL and Python share but for the words of types and functions:
//
//   name = expression          a number; `vec3 name = expression` a vector or colour
//
// What an expression may use: n, l, v (unit), n_l, n_v, l_v (their products), shininess, roughness, f0, pi,
// dot, cross, unit, max, sqrt, pow, power (0 to the power 0 is 1), over (a / b, 0 for b = 0), above_zero (1
// or 0), and the names before it. The results are `diffuse` and, where the model has a highlight, `S`.

#include <string>

#include "programs/program.h"
#include "programs/template.h"

namespace glint {

struct ModelText {
    std::string text;  // whole lines, indented
    Flags uses;        // "uses.NAME" of each name in it
};

/// The lines of what the scene's terms need; mistakes in them are written and marked. `indent` begins each.
[[nodiscard]] ModelText model_text(const Shading& shading, bool diffuse_wanted, Language language,
                                   const std::string& indent);

}  // namespace glint
