// Closed forms: sizes, areas, volumes, Euler's formula; counts of the teapot from its published table.
#include "models/mesh/primitives/primitives.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "models/fields/choices.h"
#include "models/mesh/normals.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_helpers.h"

using namespace glint;

namespace {

constexpr Primitive all[] = {Primitive::Sphere,   Primitive::BumpySphere, Primitive::Icosphere,
                             Primitive::Cube,     Primitive::Plane,       Primitive::TessellatedQuad,
                             Primitive::Torus,    Primitive::Cylinder,    Primitive::Cone,
                             Primitive::Teapot,   Primitive::Knot,        Primitive::SkewQuad,
                             Primitive::TJunction};

bool is_closed(Primitive p) {
    return p != Primitive::Plane && p != Primitive::TessellatedQuad && p != Primitive::Teapot &&
           p != Primitive::SkewQuad && p != Primitive::TJunction;
}

/// The volume enclosed by the triangles (by the divergence theorem), and their area.
struct Size {
    double volume = 0, area = 0;
};
Size size_of(const Mesh& mesh) {
    Size size;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 a = test::corner_place(mesh, t.corner[0]), b = test::corner_place(mesh, t.corner[1]),
                         c = test::corner_place(mesh, t.corner[2]);
        size.volume += glm::dot(a, glm::cross(b, c)) / 6;
        size.area += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return size;
}

glm::vec3 normal_of(const Mesh& mesh, std::uint32_t corner) {
    return mesh
        .normals[mesh.corner_normal.empty() ? mesh.corner_position[corner] : mesh.corner_normal[corner]];
}

void check_normals(const Mesh& mesh) {
    std::size_t not_unit = 0, turned_away = 0;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 a = test::corner_place(mesh, t.corner[0]), b = test::corner_place(mesh, t.corner[1]),
                         c = test::corner_place(mesh, t.corner[2]);
        const glm::dvec3 facet = glm::cross(b - a, c - a);
        for (const std::uint32_t corner : t.corner) {
            const glm::dvec3 n(normal_of(mesh, corner));
            not_unit += std::abs(glm::length(n) - 1) < 1e-6 ? 0 : 1;
            turned_away += glm::dot(n, facet) > 0 ? 0 : 1;
        }
    }
    CHECK(not_unit == 0);
    CHECK(turned_away == 0);
}

}  // namespace

TEST_CASE("every primitive is sound at every level of detail", "[primitives]") {
    for (const Primitive p : all)
        for (int detail : {1, 2, 3, 4, 5, 7, 8, 11, 16, 33, info_of(p).default_detail}) {
            if (detail > info_of(p).max_detail || (p == Primitive::Icosphere && detail > 5)) continue;
            INFO(name_of(p) << " " << detail);
            const Mesh mesh = make_primitive(p, detail);
            const MeshInfo info = mesh_info(mesh);
            CHECK(info.degenerate_faces == 0);
            CHECK(info.duplicate_faces == 0);
            CHECK(info.non_manifold_edges == 0);
            CHECK(info.inconsistent_edges == 0);
            CHECK(used_source(mesh, NormalSource::Auto) == NormalSource::Analytic);
            CHECK(mesh.warnings.empty());
            for (int i = 0; i < 3; ++i) CHECK(std::abs(info.bounds.min[i] + info.bounds.max[i]) < 1e-6f);
            if (is_closed(p)) {
                CHECK(info.boundary_edges == 0);
                const bool ring = p == Primitive::Torus || p == Primitive::Knot;  // Euler: V - E + F
                CHECK(info.vertices + info.faces == info.edges + (ring ? 0 : 2));
                CHECK(size_of(mesh).volume > 0);
            }
            // The teapot's lip turns too sharply when it has few cells (91 degrees between facets at 12).
            if (p != Primitive::Teapot) check_normals(mesh);
        }
}

TEST_CASE("primitives have the documented sizes and faces", "[primitives]") {
    const auto bounds = [](Primitive p) { return make_primitive(p, info_of(p).default_detail).bounds; };
    const auto info = [](Primitive p, int d) { return mesh_info(make_primitive(p, d)); };
    CHECK(bounds(Primitive::Sphere) == Bounds{{-1, -1, -1}, {1, 1, 1}});
    CHECK(bounds(Primitive::Cube) == Bounds{{-1, -1, -1}, {1, 1, 1}});
    CHECK(bounds(Primitive::Cylinder) == Bounds{{-1, -1, -1}, {1, 1, 1}});
    CHECK(bounds(Primitive::Cone) == Bounds{{-1, -1, -1}, {1, 1, 1}});
    CHECK(bounds(Primitive::Torus) == Bounds{{-1.4f, -0.4f, -1.4f}, {1.4f, 0.4f, 1.4f}});
    CHECK(bounds(Primitive::Plane) == Bounds{{-1, 0, -1}, {1, 0, 1}});
    CHECK(info(Primitive::Sphere, 48).quads == 1056u);    // 48 x (24 - 2)
    CHECK(info(Primitive::Sphere, 48).triangles == 96u);  // two caps of 48
    CHECK(info(Primitive::Sphere, 7).quads == 14u);       // 4 stacks
    CHECK(info(Primitive::Icosphere, 3).triangles == 1280);
    CHECK(info(Primitive::Cube, 1).vertices == 8);
    CHECK(info(Primitive::Cube, 5).quads == 150);
    CHECK(info(Primitive::Cube, 5).vertices == 152u);  // 6 n^2 + 2
    CHECK(info(Primitive::Torus, 48).quads == 1152u);  // 48 x 24
    CHECK(info(Primitive::Knot, 256).quads == 8192u);  // 256 x 32
    CHECK(info(Primitive::Knot, 100).quads == 1300u);  // 100 x 13
    CHECK(info(Primitive::TessellatedQuad, 8).quads == 64);
    CHECK(info(Primitive::Cylinder, 48).quads == 48);
    CHECK(info(Primitive::Cylinder, 48).polygons == 2);
    CHECK(info(Primitive::Cone, 48).triangles == 48);
    CHECK(info(Primitive::Cone, 48).polygons == 1);
}

TEST_CASE("finely tessellated primitives approach the areas and volumes of their surfaces", "[primitives]") {
    const double pi = 3.14159265358979;
    const auto size = [](Primitive p, int d) { return size_of(make_primitive(p, d)); };
    CHECK(size(Primitive::Sphere, 400).volume == Approx(4 * pi / 3).epsilon(1e-3));
    CHECK(size(Primitive::Sphere, 400).area == Approx(4 * pi).epsilon(1e-3));
    CHECK(size(Primitive::Icosphere, 6).volume == Approx(4 * pi / 3).epsilon(1e-3));
    CHECK(size(Primitive::Torus, 400).volume == Approx(2 * pi * pi * 0.16).epsilon(1e-3));  // Pappus
    CHECK(size(Primitive::Torus, 400).area == Approx(4 * pi * pi * 0.4).epsilon(1e-3));
    CHECK(size(Primitive::Cylinder, 400).volume == Approx(2 * pi).epsilon(1e-3));
    CHECK(size(Primitive::Cylinder, 400).area == Approx(6 * pi).epsilon(1e-3));
    CHECK(size(Primitive::Cone, 400).volume == Approx(2 * pi / 3).epsilon(1e-3));
    CHECK(size(Primitive::Cone, 400).area == Approx(pi * (1 + std::sqrt(5.0))).epsilon(1e-3));
    CHECK(size(Primitive::Cube, 3).volume == Approx(8));
    // A tube's volume is its cross-section times the length of its centre line (Pappus again), which is found
    // by Simpson's rule.
    double length = 0;
    for (int i = 0; i <= 2000; ++i) {
        const double t = 2 * pi * i / 2000, along = 2 * (0.85 + 0.4 * std::cos(3 * t));
        length += std::sqrt(along * along + 1.44) * (i == 0 || i == 2000 ? 1 : i % 2 != 0 ? 4 : 2);
    }
    length *= 2 * pi / 2000 / 3;
    CHECK(size(Primitive::Knot, 2000).volume == Approx(pi * 0.0625 * length).epsilon(1e-3));
}

TEST_CASE("analytic normals agree with the averaged normals of a fine mesh", "[primitives][normals]") {
    for (const Primitive p : {Primitive::Sphere, Primitive::BumpySphere, Primitive::Icosphere,
                              Primitive::Torus, Primitive::Knot, Primitive::Plane}) {
        INFO(name_of(p));
        const Mesh mesh = make_primitive(p, p == Primitive::Icosphere ? 6
                                            : p == Primitive::Knot    ? 1600
                                                                      : 500);
        NormalOptions options;
        options.source = NormalSource::Vertex;
        const CornerNormals averaged = corner_normals(mesh, options);
        REQUIRE(averaged.corner.empty());
        double least = 1;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            least = std::min(least, glm::dot(glm::dvec3(averaged.normals[v]), glm::dvec3(mesh.normals[v])));
        CHECK(least > 0.9995);
    }
}

TEST_CASE("the bumps of the bumpy sphere reach 0.05 up and down", "[primitives]") {
    const Mesh mesh = make_primitive(Primitive::BumpySphere, 600);
    double low = 2, high = 0;
    for (const glm::vec3& p : mesh.positions) {
        low = std::min(low, static_cast<double>(glm::length(p)));
        high = std::max(high, static_cast<double>(glm::length(p)));
    }
    CHECK(low == Approx(0.95).margin(1e-4));
    CHECK(high == Approx(1.05).margin(1e-4));
}

TEST_CASE("each pole of a sphere is one vertex with an exact normal", "[primitives][degenerate]") {
    const Mesh mesh = make_primitive(Primitive::Sphere, 48);
    int poles = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (mesh.positions[v].x == 0 && mesh.positions[v].z == 0) {
            ++poles;
            CHECK(mesh.normals[v] == mesh.positions[v]);
        }
    CHECK(poles == 2);
}

TEST_CASE("cylinder and cone have sharp rims, the cone's tip has one normal per facet", "[primitives]") {
    const Mesh cylinder = make_primitive(Primitive::Cylinder, 4), cone = make_primitive(Primitive::Cone, 4);
    for (std::uint32_t c = 0; c < 16; ++c) CHECK(normal_of(cylinder, c).y == 0);
    for (std::uint32_t c = 16; c < 20; ++c) CHECK(normal_of(cylinder, c) == glm::vec3(0, 1, 0));
    for (std::uint32_t c = 20; c < 24; ++c) CHECK(normal_of(cylinder, c) == glm::vec3(0, -1, 0));
    // The side has slope 2: its normal is (2, 1)/sqrt 5 in its plane, and at the tip halfway between its
    // neighbours'.
    for (std::uint32_t f = 0; f < 4; ++f) {
        const glm::vec3 a = normal_of(cone, 3 * f), b = normal_of(cone, 3 * f + 1),
                        tip = normal_of(cone, 3 * f + 2);
        CHECK(a.y == Approx(0.4472136));
        CHECK(tip.y == Approx(0.4472136));
        CHECK(glm::dot(tip, a) == Approx(glm::dot(tip, b)));
    }
}

TEST_CASE("the teapot has the counts, area and extents in its table", "[primitives][teapot]") {
    struct Row {
        std::size_t d, triangles, edges, boundary;
        double area;
    };
    const Row rows[] = {{2, 240, 376, 32, 48.016860},      {4, 992, 1520, 64, 51.555028},
                        {8, 4032, 6112, 128, 52.537029},   {10, 6320, 9560, 160, 52.660796},
                        {12, 9120, 13776, 192, 52.728294}, {16, 16256, 24512, 256, 52.795904},
                        {32, 65280, 98176, 512, 52.861417}};
    for (const Row& row : rows) {
        INFO("d = " << row.d);
        const Mesh mesh = make_primitive(Primitive::Teapot, static_cast<int>(row.d));
        const MeshInfo info = mesh_info(mesh);
        CHECK(info.vertices == 32 * row.d * row.d + 4 * row.d + 2);  // welded within each part
        CHECK(info.triangles == row.triangles);
        CHECK(info.faces == row.triangles);
        CHECK(info.edges == row.edges);
        CHECK(info.boundary_edges == row.boundary);
        CHECK(info.non_manifold_edges == 0);
        CHECK(info.inconsistent_edges == 0);
        CHECK(size_of(mesh).area == Approx(row.area).epsilon(1e-6));
    }
    const Bounds bounds = make_primitive(Primitive::Teapot, 32).bounds;
    CHECK(bounds.max.y == Approx(1.575));  // lid up y, 0 to 3.15
    CHECK(bounds.max.z == Approx(2));
    CHECK(bounds.max.x == Approx((3 + 3.434075) / 2).epsilon(1e-3));
}

TEST_CASE("the teapot's normals match those worked out by hand", "[primitives][teapot]") {
    const Mesh mesh = make_primitive(Primitive::Teapot, 4);
    const float shift =
        3.434075f / 2 - 1.5f;  // the bounds' centre, roughly: the tessellated spout is a little shorter
    const auto check = [&](glm::vec3 s, glm::vec3 n) {  // S and n, z up
        const glm::vec3 place(s.x - shift, s.z - 1.575f, -s.y), expected(n.x, n.z, -n.y);
        std::size_t nearest = 0;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            if (glm::distance(mesh.positions[v], place) < glm::distance(mesh.positions[nearest], place))
                nearest = v;
        CHECK(glm::distance(mesh.positions[nearest], place) < 0.02f);
        CHECK(glm::distance(mesh.normals[nearest], expected) < 2e-6f);
    };
    check({1.3090625f, -1.3090625f, 1.621875f}, {0.662761f, -0.662761f, 0.348563f});
    check({-2.51875f, -0.225f, 2.0953125f}, {0, -1, 0});
    check({2.5375f, -0.34125f, 1.621875f}, {0.214084f, -0.960035f, 0.180281f});
    check({3.093164063f, -0.17578125f, 2.448779297f}, {-0.011162f, -0.838970f, 0.544063f});
    check({0.23103125f, -0.23103125f, 2.98125f}, {0.550896f, -0.550896f, -0.626919f});
    check({0.91190625f, 0.91190625f, 0.046875f}, {0.099601f, 0.099601f, -0.990030f});
    check({0, 0, 3.15f}, {0, 0, 1});  // poles
    check({0, 0, 0}, {0, 0, -1});
}

TEST_CASE("the lecture's figures have their documented corners, values and faces", "[primitives]") {
    const Mesh quad = make_primitive(Primitive::SkewQuad, 1);
    const std::vector<glm::vec3> corners{{-3, -2, 0}, {1, -2, 0}, {3, 2, 0}, {-3, 2, 0}};  // minus (3, 2)
    CHECK(quad.positions == corners);
    CHECK(quad.colors == std::vector<glm::vec3>{glm::vec3(0), glm::vec3(1), glm::vec3(0), glm::vec3(1)});
    CHECK(quad.face_count() == 1);
    const Mesh left_out = make_primitive(Primitive::TJunction, 1),
               shared = make_primitive(Primitive::TJunction, 2);
    CHECK(left_out.corners_of(0).size() == 4);
    CHECK(shared.corners_of(0).size() == 5);
    CHECK(left_out.face_count() == 3);
    CHECK(left_out.positions[1] == glm::vec3(0, 0, 0));  // B
    CHECK(left_out.colors[1] == glm::vec3(0.9f));
}
