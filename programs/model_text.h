#pragma once
// A reflection model's formula (ReflectionInfo::program) in a program's language. The row contains it once,
// as statements that C++, GLSL and Python share except for the names of types and functions:
//
//   name = expression          a number; `vec3 name = expression` a vector or colour
//
// An expression may use n, l, v (unit), n_l, n_v, l_v (their products), shininess, roughness, f0, pi, dot,
// cross, unit, max, sqrt, pow, power (0 to the power 0 is 1), over (a / b, 0 for b = 0), above_zero (1 or 0),
// and earlier names. The results are `diffuse` and, if the model has a highlight, `S`.

#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/program.h"
#include "programs/template.h"

namespace glint {

struct ModelText {
    std::string text;  // complete lines, indented
    Flags uses;        // "uses.NAME" of each name in it
};

/// The lines that the scene's terms need, including its mistakes, which are marked. Each begins with
/// `indent`. With several models, the lines test m.model, whose values are the models' identifiers.
[[nodiscard]] ModelText model_text(const Shading& shading, const std::vector<Reflection>& models,
                                   bool diffuse_wanted, Language language, const std::string& indent);

/// The name of a model in a program: "blinn_phong".
[[nodiscard]] std::string identifier_of(Reflection model);

// A mesh in the format of the programs: a text of numbers that three lines of code read in any language.
//
//   positions COUNT    then x y z each, object coordinates
//   normals COUNT      likewise, unit vectors
//   colors COUNT       one per position, or none: linear red, green, blue
//   faces COUNT        polygons, each: number of corners, then for each corner its position and its normal
//   triangles COUNT    each: its polygon, then three of that polygon's corners; all numbers from 0

/// The mesh of an object with its normals, including mistakes in reading normals. Precondition: it is loaded.
[[nodiscard]] std::string mesh_text(const Object& object, const Mistakes& mistakes);

}  // namespace glint
