// Compares transformed vertices and normals with GLM's own arithmetic in double.
#include "renderer/geometry/geometry.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderer/geometry/geometry_kernels.h"
#include "renderer/geometry/object_normals.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

/// `count` vertices all around the camera: in front and behind, in and out of view.
Scene scattered(std::mt19937& random, int count) {
    std::vector<glm::vec3> positions;
    for (int i = 0; i < count; ++i) positions.push_back(uniform_vec3(random, -6, 6));
    Mesh mesh = make_mesh(positions, {{0, 1, 2}});
    mesh.given_normals = GivenNormals::File;
    for (int i = 0; i < count; ++i)
        mesh.normals.push_back(i == 1 ? glm::vec3(0) : uniform_vec3(random, -1, 1));
    Scene scene;
    scene.objects.push_back(object_of(std::make_shared<const Mesh>(std::move(mesh))));
    scene.objects[0].transform = {{0.3f, -0.2f, 0.1f}, {20, 35, 10}, {-0.6f, 0.8f, 1.5f}};
    scene.camera.eye = {1, 2, 4};
    return scene;
}

std::uint32_t outside(const glm::dvec4& c) {
    std::uint32_t bits = 0;
    if (c.x < -c.w) bits |= OutsideLeft;
    if (c.x > c.w) bits |= OutsideRight;
    if (c.y < -c.w) bits |= OutsideBottom;
    if (c.y > c.w) bits |= OutsideTop;
    if (c.z < -c.w) bits |= OutsideNear;
    if (c.z > c.w) bits |= OutsideFar;
    if (!(std::abs(c.x) <= 64 * c.w && std::abs(c.y) <= 64 * c.w)) bits |= OutsideGuard;
    return bits;
}

}  // namespace

TEST_CASE("transformed vertices match GLM's, for any count", "[geometry]") {
    std::mt19937 random(17);
    const PictureSize size{640, 360};
    std::uint32_t met = 0;
    for (int count = 3; count < 60; ++count) {
        Scene scene = scattered(random, count);
        if (count % 3 == 0) scene.camera.projection = Orthographic{5, 0.1f, 9};
        Geometry g;
        REQUIRE(update_geometry(g, scene, size));
        const ObjectGeometry& o = g.objects[0];
        const glm::dmat4 clip_from_camera = clip_from_view(scene.camera.projection, size);
        REQUIRE(o.vertices.size() == static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < o.vertices.size(); ++i) {
            const glm::dvec4 p = o.view_from_object * glm::dvec4(glm::dvec3(o.mesh->positions[i]), 1);
            const glm::dvec4 c = clip_from_camera * p;
            const TransformedVertex& v = o.vertices[i];
            CHECK(glm::vec3(v.x, v.y, v.z) == glm::vec3(p));
            CHECK(glm::vec3(v.clip_x, v.clip_y, v.clip_w) == glm::vec3(c.x, c.y, c.w));
            REQUIRE(v.outside == outside(c));
            met |= v.outside;
            const ScreenVertex& s = o.screen[i];
            CHECK(s.outside == v.outside);
            if (v.outside & needs_clipping) continue;
            CHECK(s.x == std::lround((c.x / c.w + 1) * 0.5 * size.width * 256));
            CHECK(s.y == std::lround((1 - c.y / c.w) * 0.5 * size.height * 256));
            CHECK(s.inv_w == static_cast<float>(count % 3 == 0 ? 0.5 * (1 - c.z / c.w) : 1 / c.w));
        }
    }
    CHECK(met == 127);  // every flag of `outside` occurred
}

TEST_CASE("transformed normals match GLM's and are of unit length or zero", "[geometry]") {
    std::mt19937 random(18);
    for (int count = 3; count < 30; ++count) {
        const Scene scene = scattered(random, count);
        Geometry g;
        REQUIRE(update_geometry(g, scene, {64, 64}));
        std::vector<ObjectNormals> normals;
        update_normals(normals, scene, g, {});
        const std::vector<glm::vec3>& from = normals[0].of_mesh->normals;
        REQUIRE(from.size() >= static_cast<std::size_t>(count));
        REQUIRE(normals[0].normals.size() == from.size());
        for (std::size_t i = 0; i < from.size(); ++i) {
            const glm::dvec3 n = g.objects[0].normal_matrix * glm::dvec3(from[i]);
            const double length = glm::length(n);
            CHECK(normals[0].normal(static_cast<std::uint32_t>(i)) ==
                  (length > 0 ? glm::vec3(n / length) : glm::vec3(0)));
        }
    }
}
