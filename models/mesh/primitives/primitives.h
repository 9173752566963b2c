#pragma once
// The built-in meshes (docs/scene_file.md, table of primitives). Their bounds are centred at the origin; y is
// up, faces are counter-clockwise seen from outside, and normals are analytic, including at the poles.

#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/numbers.h"
#include "models/progress.h"

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

struct PrimitiveBuilder;  // models/mesh/primitives/primitives.h

// The generators; d >= 1 is the detail. Files: primitives.cpp, teapot.cpp.
[[nodiscard]] PrimitiveBuilder make_sphere(int d);
[[nodiscard]] PrimitiveBuilder make_bumpy_sphere(int d);
[[nodiscard]] PrimitiveBuilder make_icosphere(int d);
[[nodiscard]] PrimitiveBuilder make_cube(int d);
[[nodiscard]] PrimitiveBuilder make_plane(int d);
[[nodiscard]] PrimitiveBuilder make_torus(int d);
[[nodiscard]] PrimitiveBuilder make_cylinder(int d);
[[nodiscard]] PrimitiveBuilder make_cone(int d);
[[nodiscard]] PrimitiveBuilder make_teapot(int d);
[[nodiscard]] PrimitiveBuilder make_knot(int d);
[[nodiscard]] PrimitiveBuilder make_skew_quad(int);
[[nodiscard]] PrimitiveBuilder make_t_junction(int d);

/// One row per primitive: its texts, its maximum detail, and its generator. The maximum limits a mesh to
/// about 8 million triangles (icosphere: 1.3 million); `detail_meaning` says what d counts.
struct PrimitiveInfo {
    Choice choice;  // its meaning describes the shape
    int default_detail = 1, max_detail = 1;
    const char* detail_meaning = "";
    PrimitiveBuilder (*make)(int d);
};

// NOLINTNEXTLINE(readability-function-size): a table, one case per row.
constexpr PrimitiveInfo info_of(Primitive primitive) {
    switch (primitive) {
    case Primitive::Sphere:
        return {{"sphere", "Sphere", "radius 1"}, 48, 2800, "d slices, ⌈d/2⌉ stacks", make_sphere};
    case Primitive::BumpySphere:
        return {{"bumpy-sphere", "Bumpy sphere", "radius 1, bumps of ±0.05"},
                48,
                2800,
                "d slices, ⌈d/2⌉ stacks",
                make_bumpy_sphere};
    case Primitive::Icosphere:  // 20 * 4^d triangles: 9 would be 5 million, 10 would exceed the limit
        return {
            {"icosphere", "Icosphere", "radius 1"}, 3, 8, "d subdivisions of an icosahedron", make_icosphere};
    case Primitive::Cube:
        return {{"cube", "Cube", "edge 2"}, 1, 800, "d × d quads per side", make_cube};
    case Primitive::Plane:
        return {{"plane", "Plane", "2 × 2 in x and z, facing up"}, 1, 2000, "d × d quads", make_plane};
    case Primitive::TessellatedQuad:
        return {{"tessellated-quad", "Tessellated quad", "2 × 2 in x and z, facing up"},
                8,
                2000,
                "d × d quads",
                make_plane};
    case Primitive::Torus:
        return {{"torus", "Torus", "radii 1 and 0.4 around y"}, 48, 2800, "d × ⌈d/2⌉ quads", make_torus};
    case Primitive::Cylinder:
        return {
            {"cylinder", "Cylinder", "radius 1, height 2, closed"}, 48, 1'000'000, "d slices", make_cylinder};
    case Primitive::Cone:
        return {{"cone", "Cone", "radius 1, height 2, closed"}, 48, 1'000'000, "d slices", make_cone};
    case Primitive::Teapot:
        return {
            {"teapot", "Teapot", "the Utah teapot, lid up"}, 12, 350, "d × d cells per patch", make_teapot};
    case Primitive::Knot:
        return {{"knot", "Knot", "(2, 3) torus knot, tube of 0.25, within 1.5"},
                256,
                5600,
                "d × ⌈d/8⌉ quads",
                make_knot};
    case Primitive::SkewQuad:
        return {{"skew-quad", "Skew quad", "a quadrilateral with vertex colours"},
                1,
                1,
                "only 1",
                make_skew_quad};
    case Primitive::TJunction:
        return {{"t-junction", "T-junction", "two faces and one with a corner on their edge"},
                1,
                2,
                "1: the corner belongs to one side, 2: to both",
                make_t_junction};
    }
    return {};
}

/// A new mesh; `load_ms` is the time taken to make it. Closed meshes share their vertices along every seam
/// and have one vertex at a pole. A detail too small for a solid yields the smallest one: 3 slices and 2
/// stacks (sphere), 3 x 3 (torus), 3 slices (cylinder, cone), 12 x 3 (knot), 2 x 2 per patch (teapot).
/// Spheres and cubes have quads, with triangles at the poles; caps are one polygon; the teapot, which is
/// open, is cut into triangles.
/// Precondition: 1 <= detail <= info_of(primitive).max_detail.
/// Throws LoadCancelled (models/progress.h) when this thread's load is cancelled.
[[nodiscard]] Mesh make_primitive(Primitive primitive, int detail);

// Shared parts of the generators of primitives. Internal to models/.

/// A polygon mesh under construction, in double until it is centred. Adding to it reports the load's progress
/// regularly and may throw LoadCancelled.
struct PrimitiveBuilder {
    std::vector<glm::dvec3> positions, normals;
    std::vector<std::uint32_t> first_corner{0}, corner_position;
    std::vector<std::uint32_t> corner_normal;  // empty: each position has one normal
    std::vector<glm::vec3> colors;

    /// Adds a position with its normal; returns its index.
    std::uint32_t vertex(const glm::dvec3& position, const glm::dvec3& normal) {
        if (positions.size() % between_reports == 0) report_or_leave(LoadStage::Building, face_count());
        positions.push_back(position);
        normals.push_back(normal);
        return static_cast<std::uint32_t>(positions.size() - 1);
    }
    /// A polygon whose corners use the normals of their positions.
    void face(std::initializer_list<std::uint32_t> corners) {
        corner_position.insert(corner_position.end(), corners);
        close_face();
    }
    /// Adds a corner of the polygon that close_face() ends. Used if a position may have several normals.
    void corner(std::uint32_t position, std::uint32_t normal) {
        corner_position.push_back(position);
        corner_normal.push_back(normal);
    }
    void close_face() {
        if (first_corner.size() % between_reports == 0) report_or_leave(LoadStage::Building, face_count());
        first_corner.push_back(static_cast<std::uint32_t>(corner_position.size()));
    }
    [[nodiscard]] std::size_t face_count() const { return first_corner.size() - 1; }

    static constexpr std::size_t between_reports = 1 << 14;  // vertices, faces
};

/// Adds a grid of quads that is closed in both directions, `columns` to the right by `rows` up as seen from
/// outside: vertex (i, j) has the index i * rows + j. Precondition: the vertices exist.
void add_closed_grid(PrimitiveBuilder& to, std::uint32_t columns, std::uint32_t rows);

}  // namespace glint
