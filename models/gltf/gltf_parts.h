#pragma once
// Which primitives of a mesh can be drawn. Inside models/gltf/ only.

#include "models/json/json_node.h"

namespace glint {

/// How the vertices of a primitive follow one another; None: it has no triangles.
enum class PrimitiveMode { None, Triangles, Strip, Fan };
/// Precondition: the primitive is an object.
[[nodiscard]] PrimitiveMode mode_of(const Node& primitive);

}  // namespace glint
