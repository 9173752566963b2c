#pragma once
// The meshes that need no file (docs/interface.md, table of primitives). All are centred at the origin by
// their bounds, y up, counter-clockwise outward, with analytic normals, poles included.

#include <string_view>

#include "models/mesh.h"

namespace glint {

enum class Primitive {
    Sphere,
    BumpySphere,
    Icosphere,
    Cube,
    Plane,
    TessellatedQuad,
    Torus,
    Cylinder,
    Cone,
    Teapot,
    Knot,
    SkewQuad,
    TJunction
};

/// The name in the scene file: "sphere", "bumpy-sphere", ...
[[nodiscard]] std::string_view primitive_name(Primitive primitive);
[[nodiscard]] int default_detail(Primitive primitive);
/// The largest detail: the most that keeps a mesh within about 8 million triangles (icosphere: 1.3 million).
[[nodiscard]] int max_detail(Primitive primitive);

/// A new mesh; `load_ms` is the time it took. Closed ones share their vertices along every seam and have one
/// vertex at a pole. A detail too small for a solid gives the smallest one: 3 slices and 2 stacks (sphere), 3
/// x 3 (torus), 3 slices (cylinder, cone), 12 x 3 (knot), 2 x 2 a patch (teapot). Spheres and cubes have
/// quads with triangles at the poles; caps are one polygon; the teapot, which is open, is cut into triangles.
/// Precondition: 1 <= detail <= max_detail(primitive).
/// Throws LoadCancelled (models/progress.h) when this thread's load shall end.
[[nodiscard]] Mesh make_primitive(Primitive primitive, int detail);

}  // namespace glint
