// Objects between a point and a light, against points worked by hand and against the shadows of a sphere.
#include "renderer/debug_views/blocker.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

/// A ball of radius 1 at (0, 2, 0) over a floor at y = 0.
Scene ball_over_floor() {
    Scene scene;
    scene.objects.resize(2);
    scene.objects[0].mesh = primitive(Primitive::Plane, 1);
    scene.objects[0].transform.scale = glm::vec3(10);
    scene.objects[1].mesh = primitive(Primitive::Sphere, 64);
    scene.objects[1].transform.translate = {0, 2, 0};
    return scene;
}

}  // namespace

TEST_CASE("blocker: a ball shades the disc of the floor given by its closed form", "[blocker][lecture]") {
    const Scene scene = ball_over_floor();
    int shaded = 0;
    for (int i = -40; i <= 40; ++i)
        for (int j = -40; j <= 40; ++j) {
            const glm::dvec3 point(0.1 * i, 0, 0.1 * j);
            const double out = std::hypot(point.x, point.z);
            // A sun overhead: the ball's own disc. A bulb at (0, 4, 0): tan of the cone's half angle is 1 /
            // sqrt(3), so a disc of radius 4 / sqrt(3). Within 1 % of the rim the tessellation matters.
            for (const auto& [radius, distance, to] :
                 {std::tuple{1.0, 0.0, glm::dvec3(0, 1, 0)},
                  std::tuple{4 / std::sqrt(3.0), glm::length(glm::dvec3(0, 4, 0) - point),
                             glm::dvec3(0, 4, 0) - point}}) {
                if (std::abs(out - radius) < 0.01 * radius + 0.005) continue;
                const auto by = blocker(scene, point, to, distance);
                CHECK(by == (out < radius ? std::optional(1) : std::nullopt));
                shaded += by.has_value();
            }
        }
    CHECK(shaded > 1000);
}

TEST_CASE("blocker: objects behind the light and the surface itself do not block", "[blocker]") {
    const Scene scene = ball_over_floor();
    CHECK(blocker(scene, {0, 0, 0}, {0, 1, 0}, 0) == 1);
    CHECK(blocker(scene, {0, 0, 0}, {0, 1, 0}, 0.9) == std::nullopt);  // the light is below the ball
    CHECK(blocker(scene, {0, 3, 0}, {0, 1, 0}, 0) == std::nullopt);    // on the ball's top
    CHECK(blocker(scene, {0, 1, 0}, {0, 1, 0}, 0) == 1);               // its underside: the ball itself
    CHECK(blocker(scene, {0, 1, 0}, {0, -5, 0}, 5) == 0);              // the floor, from above
    CHECK(blocker(scene, {0, 1, 0}, {0, -5, 0}, 1) == std::nullopt);   // a light on the floor
}

TEST_CASE("blocker: transformed faces block, also if mirrored, rotated or stretched", "[blocker]") {
    Scene scene = ball_over_floor();
    scene.objects[1].transform = {{1, 2, -1}, {20, 30, 40}, {-2, 0.5f, 1}};
    const glm::mat4 world = world_from_object(scene.objects[1].transform);
    const glm::dvec3 inside(world * glm::vec4(0.3f, -0.2f, 0.1f, 1));
    CHECK(blocker(scene, {inside.x, 0, inside.z}, {0, 1, 0}, 0) == 1);
    scene.objects[1].transform.scale.y = 0;  // flattened: ignored without a crash
    CHECK(blocker(scene, {inside.x, 0, inside.z}, {0, 1, 0}, 0) == std::nullopt);
}
