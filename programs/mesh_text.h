#pragma once
// A mesh in the format of the programs: a text of numbers that three lines of code read in any language.
//
//   positions COUNT    then x y z each, object coordinates
//   normals COUNT      likewise, unit
//   colors COUNT       one per position, or none: linear red, green, blue
//   faces COUNT        polygons, each: number of corners, then for each corner its position and its normal
//   triangles COUNT    each: its polygon, then three of that polygon's corners; all numbers from 0

#include <string>

#include "models/scene/scene.h"

namespace glint {

/// The mesh of an object with its normals, including the mistakes in reading normals. Precondition: loaded.
[[nodiscard]] std::string mesh_text(const Object& object, const Mistakes& mistakes);

}  // namespace glint
