#pragma once
// The meshes that need no file (docs/interface.md, table of primitives). All are centred at the origin by their
// bounds, y up, counter-clockwise outward, with analytic normals, poles included.

#include <string_view>

#include "models/mesh.h"

namespace glint {

enum class Primitive {
    Sphere, BumpySphere, Icosphere, Cube, Plane, TessellatedQuad, Torus, Cylinder, Cone, Teapot, Knot, SkewQuad,
    TJunction
};

/// The name in the scene file: "sphere", "bumpy-sphere", ...
[[nodiscard]] std::string_view primitive_name(Primitive primitive);
[[nodiscard]] int default_detail(Primitive primitive);
/// The largest detail: beyond it the mesh would pass 2^31 - 1 corners or the memory of a plain laptop.
[[nodiscard]] int max_detail(Primitive primitive);

/// A new mesh. Precondition: 1 <= detail <= max_detail(primitive).
[[nodiscard]] Mesh make_primitive(Primitive primitive, int detail);

}  // namespace glint
