#pragma once
// A reflection model's formula (ReflectionInfo::program) in a program's language. The model's table row
// contains the formula once, as statements that C++, GLSL and Python share except for the names of types and
// functions:
//
//   name = expression          a number; `vec3 name = expression` a vector or colour
//
// An expression may use n, l, v (unit), n_l, n_v, l_v (their products), shininess, roughness, f0, pi, dot,
// cross, unit, max, sqrt, pow, power (0 to the power 0 is 1), over (a / b, 0 for b = 0), above_zero (1 or 0),
// and earlier names. The results are `diffuse` and, if the model has a highlight, `S`.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"
#include "programs/program.h"

namespace glint {

// The templates are programs: texts that contain all variants, each marked by a directive that is a comment
// in their language (`//@...`, in Python `#@...`), alone on its line.
//
//   //@if COND, //@else, //@end   a condition on flags: `a`, `!a`, `a&b`, `a|b` (& binds tighter than |)
//   //@can FLAG...                features that need no separate text
//   //@calls NAME                 from here on the lines are calls with that name, which gl_calls.h reads;
//                                 `//@calls` alone ends them
//   @name@                        a value; alone on its line it may expand to several lines
//
// If a condition names an active mistake (`wrong.NAME`), a comment on the line before it describes the
// mistake.

using Flags = std::set<std::string, std::less<>>;
using Values = std::map<std::string, std::string, std::less<>>;

/// All flags that a template mentions, which are the features that it supports.
[[nodiscard]] Flags mentioned_flags(std::string_view text);

/// The unchanged lines between `//@calls name` and the next `//@calls`. Precondition: they exist, and the
/// conditions in them are balanced (a test reads every name).
[[nodiscard]] std::string_view lines_of_calls(std::string_view text, std::string_view name);

/// The comment for an active mistake, without the comment marker.
[[nodiscard]] std::string mistake_comment(std::string_view name);

/// Returns the lines of a template whose conditions hold, with values filled in. Precondition: directives are
/// balanced and every value is given (a test fills in each template).
[[nodiscard]] std::string filled(std::string_view text, const Flags& on, const Values& values);

struct ModelText {
    std::string text;  // complete lines, indented
    Flags uses;        // "uses.NAME" of each name in it
};

/// The lines that the scene's terms need, including its mistakes, which are marked. Each line begins with
/// `indent`. With several models, the lines test m.model, whose values are the models' identifiers.
[[nodiscard]] ModelText model_text(const Shading& shading, const std::vector<Reflection>& models,
                                   bool diffuse_wanted, Language language, const std::string& indent);

/// The name of a model in a program: "blinn_phong".
[[nodiscard]] std::string identifier_of(Reflection model);

// A mesh in the format that the programs read: numbers as text, which take three lines of code in any
// language.
//
//   positions COUNT    then x y z of each, in object coordinates
//   normals COUNT      then x y z of each, unit vectors in object coordinates
//   colors COUNT       one per position, or none: linear red, green, blue
//   faces COUNT        polygons, each: number of corners, then two indices per corner: position and normal
//   triangles COUNT    each: the index of its polygon, then of three of its corners; indices start at 0

/// The mesh of an object with its normals, including mistakes in reading normals. Precondition: it is loaded.
[[nodiscard]] std::string mesh_text(const Object& object, const Mistakes& mistakes);

}  // namespace glint
