#pragma once
// The meshes that need no file (docs/interface.md, table of primitives). All are centred at the origin by
// their bounds, y up, counter-clockwise outward, with analytic normals, poles included.

#include "models/fields/choice.h"
#include "models/mesh/mesh.h"

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

/// One row a primitive: its words, and how finely it can be cut. `detail`'s maximum keeps a mesh within about
/// 8 million triangles (icosphere: 1.3 million); `detail_meaning` says what d counts.
struct PrimitiveInfo {
    Choice choice;  // its meaning is the shape
    int default_detail = 1, max_detail = 1;
    const char* detail_meaning = "";
};

constexpr PrimitiveInfo info_of(Primitive primitive) {
    switch (primitive) {
    case Primitive::Sphere:
        return {{"sphere", "Sphere", "radius 1"}, 48, 2800, "d slices, ⌈d/2⌉ stacks"};
    case Primitive::BumpySphere:
        return {
            {"bumpy-sphere", "Bumpy sphere", "radius 1, bumps of ±0.05"}, 48, 2800, "d slices, ⌈d/2⌉ stacks"};
    case Primitive::Icosphere:  // 20 * 4^d triangles: 9 would be 5 million, 10 over the limit
        return {{"icosphere", "Icosphere", "radius 1"}, 3, 8, "d subdivisions of an icosahedron"};
    case Primitive::Cube:
        return {{"cube", "Cube", "edge 2"}, 1, 800, "d × d quads a side"};
    case Primitive::Plane:
        return {{"plane", "Plane", "2 × 2 in x and z, facing up"}, 1, 2000, "d × d quads"};
    case Primitive::TessellatedQuad:
        return {
            {"tessellated-quad", "Tessellated quad", "2 × 2 in x and z, facing up"}, 8, 2000, "d × d quads"};
    case Primitive::Torus:
        return {{"torus", "Torus", "radii 1 and 0.4 around y"}, 48, 2800, "d × ⌈d/2⌉ quads"};
    case Primitive::Cylinder:
        return {{"cylinder", "Cylinder", "radius 1, height 2, closed"}, 48, 1'000'000, "d slices"};
    case Primitive::Cone:
        return {{"cone", "Cone", "radius 1, height 2, closed"}, 48, 1'000'000, "d slices"};
    case Primitive::Teapot:
        return {{"teapot", "Teapot", "the Utah teapot, lid up"}, 12, 350, "d × d cells a patch"};
    case Primitive::Knot:
        return {
            {"knot", "Knot", "(2, 3) torus knot, tube of 0.25, within 1.5"}, 256, 5600, "d × ⌈d/8⌉ quads"};
    case Primitive::SkewQuad:
        return {{"skew-quad", "Skew quad", "a quadrilateral with vertex colours, worked by hand"},
                1,
                1,
                "only 1"};
    case Primitive::TJunction:
        return {{"t-junction", "T-junction", "two faces and one with a corner on their edge"},
                1,
                2,
                "1: the corner is of one side, 2: of both"};
    }
    return {};
}

/// A new mesh; `load_ms` is the time it took. Closed ones share their vertices along every seam and have one
/// vertex at a pole. A detail too small for a solid gives the smallest one: 3 slices and 2 stacks (sphere), 3
/// x 3 (torus), 3 slices (cylinder, cone), 12 x 3 (knot), 2 x 2 a patch (teapot). Spheres and cubes have
/// quads with triangles at the poles; caps are one polygon; the teapot, which is open, is cut into triangles.
/// Precondition: 1 <= detail <= info_of(primitive).max_detail.
/// Throws LoadCancelled (models/progress.h) when this thread's load shall end.
[[nodiscard]] Mesh make_primitive(Primitive primitive, int detail);

}  // namespace glint
