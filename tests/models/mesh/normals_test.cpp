// Numbers worked out by hand: cubes, boxes and bent strips.
#include "models/mesh/normals.h"

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/mesh/primitives/primitives.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_helpers.h"

using namespace glint;
using test::make_mesh;

namespace {

const std::vector<glm::vec3> cube_corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
const std::vector<std::vector<std::uint32_t>> cube_quads{{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                                         {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};

/// The box whose x, y and z faces at its far corner are cut so that this many of their triangles meet there.
Mesh cut_box(int x, int y, int z, glm::vec3 size = glm::vec3(1)) {
    std::vector<std::vector<std::uint32_t>> faces;
    const auto cut = [&faces](std::vector<std::uint32_t> q, int at_7) {  // q[2] is vertex 7
        if (at_7 == 2) {
            faces.push_back({q[0], q[1], q[2]});
            faces.push_back({q[0], q[2], q[3]});
        } else {
            faces.push_back({q[1], q[2], q[3]});
            faces.push_back({q[0], q[1], q[3]});
        }
    };
    cut(cube_quads[0], x);
    cut(cube_quads[2], y);
    cut(cube_quads[4], z);
    for (const std::size_t f : {1u, 3u, 5u}) faces.push_back(cube_quads[f]);
    std::vector<glm::vec3> corners = cube_corners;
    for (glm::vec3& p : corners) p *= size;
    return make_mesh(corners, faces);
}

glm::vec3 at_position(const Mesh& mesh, const CornerNormals& normals, std::uint32_t position) {
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c)
        if (mesh.corner_position[c] == position)
            return normals.normals[normals.corner.empty() ? position : normals.corner[c]];
    return glm::vec3(0);
}

void check_near(glm::vec3 a, glm::vec3 b) {
    INFO(a.x << " " << a.y << " " << a.z);
    CHECK(glm::distance(a, b) < 1e-6f);
}

NormalOptions vertex(NormalWeighting weighting, float crease_deg = 180) {
    return {NormalSource::Vertex, weighting, crease_deg};
}

}  // namespace

TEST_CASE("the facet normal of a triangle is the cross product of its edges", "[normals]") {
    check_near(facet_normal({1, 0, 0}, {0, 2, 0}, {0, 0, 3}), glm::vec3(6, 3, 2) / 7.f);
    CHECK(facet_normal({1, 2, 3}, {1, 2, 3}, {4, 5, 6}) == glm::vec3(0));
    CHECK(facet_normal({0, 0, 0}, {1, 1, 1}, {2, 2, 2}) == glm::vec3(0));
    check_near(facet_normal({0, 0, 0}, {1e7f, 0, 0}, {0, 1e7f, 0}), {0, 0, 1});
    check_near(facet_normal({0, 0, 0}, {1e-30f, 0, 0}, {0, 1e-30f, 0}), {0, 0, 1});
}

TEST_CASE("the facet normal of a polygon is Newell's", "[normals]") {
    const Mesh quad = test::make_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}});
    check_near(facet_normal(quad, 0), {-0.408248f, -0.408248f, 0.816497f});
    // The result is the same far from the origin.
    const Mesh far = test::make_polygon({{4096, 512, 64}, {4097, 512, 64}, {4097, 513, 65}, {4096, 513, 64}});
    check_near(facet_normal(far, 0), {-0.408248f, -0.408248f, 0.816497f});
}

TEST_CASE("with facet normals each corner has its face's normal", "[normals]") {
    const Mesh cube = make_mesh(cube_corners, cube_quads);
    const CornerNormals normals = corner_normals(cube, {.source = NormalSource::Facet});
    const glm::vec3 outward[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::size_t c = 0; c < 24; ++c) check_near(normals.normals[normals.corner[c]], outward[c / 4]);
}

TEST_CASE("only angle weighting ignores how a cube's faces are cut into triangles", "[normals]") {
    const float third = 0.57735027f;
    for (const auto weighting : {NormalWeighting::Uniform, NormalWeighting::Area, NormalWeighting::Angle}) {
        const Mesh even = cut_box(2, 2, 2);
        check_near(at_position(even, corner_normals(even, vertex(weighting)), 7), glm::vec3(third));
    }
    const Mesh one = cut_box(2, 1, 1), two = cut_box(2, 2, 1);
    for (const auto weighting : {NormalWeighting::Uniform, NormalWeighting::Area}) {
        check_near(at_position(one, corner_normals(one, vertex(weighting)), 7),
                   {0.816497f, 0.408248f, 0.408248f});
        check_near(at_position(two, corner_normals(two, vertex(weighting)), 7), glm::vec3(2, 2, 1) / 3.f);
    }
    check_near(at_position(one, corner_normals(one, vertex(NormalWeighting::Angle)), 7), glm::vec3(third));
    check_near(at_position(two, corner_normals(two, vertex(NormalWeighting::Angle)), 7), glm::vec3(third));
}

TEST_CASE("area weighting of a 1 x 2 x 3 box is the same for quads and triangles", "[normals]") {
    std::vector<glm::vec3> corners = cube_corners;
    for (glm::vec3& p : corners) p *= glm::vec3(1, 2, 3);
    for (const Mesh& box : {make_mesh(corners, cube_quads), cut_box(2, 2, 2, {1, 2, 3})}) {
        check_near(at_position(box, corner_normals(box, vertex(NormalWeighting::Area)), 7),
                   glm::vec3(6, 3, 2) / 7.f);
        check_near(at_position(box, corner_normals(box, vertex(NormalWeighting::Angle)), 7),
                   glm::vec3(0.57735027f));
        check_near(at_position(box, corner_normals(box, vertex(NormalWeighting::Uniform)), 7),
                   glm::vec3(0.57735027f));
    }
}

TEST_CASE("a reflex corner is weighted by its entire interior angle", "[normals]") {
    // An L in z = 0, reflex (270 degrees) at (1, 1), and a wall in x = 1 that meets it there at 90 degrees.
    const Mesh mesh =
        make_mesh({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {1, 1, 1}, {1, 2, 1}},
                  {{0, 1, 2, 3, 4, 5}, {3, 4, 7, 6}});
    check_near(at_position(mesh, corner_normals(mesh, vertex(NormalWeighting::Angle)), 3),
               glm::normalize(glm::vec3(1, 0, 3)));
    check_near(at_position(mesh, corner_normals(mesh, vertex(NormalWeighting::Uniform)), 3),
               glm::normalize(glm::vec3(1, 0, 1)));
}

TEST_CASE("a cube is smooth at a crease of 90 degrees and faceted at 89", "[normals][crease]") {
    const Mesh cube = make_mesh(cube_corners, cube_quads);
    const CornerNormals smooth = corner_normals(cube, vertex(NormalWeighting::Angle, 90));
    CHECK(smooth.corner.empty());
    check_near(at_position(cube, smooth, 7), glm::vec3(0.57735027f));
    const CornerNormals faceted = corner_normals(cube, vertex(NormalWeighting::Angle, 89));
    CHECK(faceted.normals.size() == 24);
    for (std::size_t c = 0; c < 24; ++c)
        check_near(faceted.normals[faceted.corner[c]], facet_normal(cube, c / 4));
}

TEST_CASE("a crease of 180 degrees averages across unshared edges, one of 179 does not",
          "[normals][crease]") {
    // Two triangles that meet only at one vertex.
    const Mesh mesh =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 4}});
    check_near(at_position(mesh, corner_normals(mesh, vertex(NormalWeighting::Angle)), 0),
               glm::normalize(glm::vec3(-1, 0, 1)));
    check_near(at_position(mesh, corner_normals(mesh, vertex(NormalWeighting::Angle, 179)), 0), {0, 0, 1});
}

TEST_CASE("corners whose normals cancel use their facet normals", "[normals][degenerate]") {
    const Mesh sheet = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
    const CornerNormals normals = corner_normals(sheet, vertex(NormalWeighting::Angle));
    REQUIRE(normals.corner.size() == 6);
    for (std::size_t c = 0; c < 6; ++c)
        check_near(normals.normals[normals.corner[c]], {0, 0, c < 3 ? 1.f : -1.f});
}

TEST_CASE("degenerate faces are ignored and have a zero normal", "[normals][degenerate]") {
    const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}},
                                {{0, 1, 2}, {0, 1, 3}, {3, 4, 5}});
    for (const auto source : {NormalSource::Vertex, NormalSource::Facet})
        for (const float crease : {30.f, 180.f}) {
            const CornerNormals n = corner_normals(mesh, {source, NormalWeighting::Angle, crease});
            check_near(at_position(mesh, n, 0), {0, 0, 1});
            check_near(at_position(mesh, n, 5), {0, 0, 0});
        }
}

TEST_CASE("a repeated corner does not count twice", "[normals][degenerate]") {
    std::vector<std::vector<std::uint32_t>> faces = cube_quads;
    faces[0] = {1, 3, 7, 7, 5};
    const Mesh cube = make_mesh(cube_corners, faces);
    for (const auto weighting : {NormalWeighting::Uniform, NormalWeighting::Area, NormalWeighting::Angle})
        for (const float crease : {120.f, 180.f})
            check_near(at_position(cube, corner_normals(cube, vertex(weighting, crease)), 7),
                       glm::vec3(0.57735027f));
}

TEST_CASE("a file's normals are normalized, corners without one use the vertex normal", "[normals]") {
    Mesh mesh = make_mesh(cube_corners, cube_quads);
    mesh.given_normals = GivenNormals::File;
    mesh.normals = {{0, 0, 1e-30f}, {0, 0, 0}, {0, 3e20f, 0}};
    mesh.corner_normal.assign(24, 0);
    mesh.corner_normal[2] = no_index;  // vertex 7
    mesh.corner_normal[5] = 1;         // zero; vertex 4
    mesh.corner_normal[6] = 2;
    const CornerNormals n = corner_normals(mesh, {});
    check_near(n.normals[n.corner[0]], {0, 0, 1});
    check_near(n.normals[n.corner[2]], glm::vec3(0.57735027f));
    check_near(n.normals[n.corner[5]], glm::vec3(-1, -1, 1) * 0.57735027f);
    check_near(n.normals[n.corner[6]], {0, 1, 0});
    CHECK(n.warnings == Warnings{"2 corners have no normal; their vertex normals are used"});
}

TEST_CASE("a normal source that the mesh lacks falls back as auto does, with a warning", "[normals]") {
    const Mesh plain = make_mesh(cube_corners, cube_quads);
    const CornerNormals file = corner_normals(plain, {NormalSource::File, NormalWeighting::Angle, 180});
    CHECK(file.warnings == Warnings{"the mesh has no \"file\" normals; \"vertex\" normals are used"});
    check_near(at_position(plain, file, 7), glm::vec3(0.57735027f));
    const Mesh cube = make_primitive(Primitive::Cube, 1);
    const CornerNormals analytic = corner_normals(cube, {NormalSource::File, NormalWeighting::Angle, 180});
    CHECK(analytic.warnings == Warnings{"the mesh has no \"file\" normals; \"analytic\" normals are used"});
    CHECK(analytic.normals.size() == 6);
    CHECK(corner_normals(cube, {}).warnings.empty());
    CHECK(corner_normals(plain, {}).warnings.empty());
}

TEST_CASE("no normal is ever NaN", "[normals][degenerate]") {
    for (const float s : {1e-38f, 1e-20f, 1.f, 1e7f}) {
        std::vector<glm::vec3> corners = cube_corners;
        for (glm::vec3& p : corners) p *= s;
        const Mesh cube = make_mesh(corners, cube_quads);
        for (const auto weighting : {NormalWeighting::Uniform, NormalWeighting::Area, NormalWeighting::Angle})
            for (const glm::vec3& n : corner_normals(cube, vertex(weighting)).normals)
                CHECK(std::abs(glm::length(n) - 1) < 1e-6f);
    }
}
