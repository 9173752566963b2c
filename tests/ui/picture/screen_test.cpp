// Mapping to the screen and back, and moving the camera with the mouse.
#include "ui/picture/screen.h"

#include <glm/geometric.hpp>
#include <random>

#include "tests/support/catch.h"
#include "ui/picture/orbit.h"

using namespace glint;

namespace {

double distance(glm::dvec2 a, glm::dvec2 b) { return glm::length(a - b); }

std::vector<Camera> cameras() {
    const glm::vec3 eye{3, 2, 4}, target{0.2f, 0.1f, -0.3f}, up{0, 1, 0};
    return {{eye, target, up, Perspective{40, 0.1f, 100}},
            {eye, target, up, Orthographic{5, 0.1f, 100}},
            {eye, target, {0.1f, 1, 0.3f}, Frustum{-0.03f, 0.07f, -0.04f, 0.05f, 0.1f, 100}}};
}

const PictureSize screen_picture{800, 600};

}  // namespace

TEST_CASE("the target of a symmetric camera is at the centre of the picture", "[ui]") {
    for (const Camera& camera : {cameras()[0], cameras()[1]}) {
        const ProjectedPoint at = project(screen_map(camera, screen_picture), camera.target);
        CHECK(distance(at.pixel, {400, 300}) < 1e-6);
        CHECK(at.depth == Approx(glm::length(camera.eye - camera.target)));
        CHECK(at.in_front);
    }
}

TEST_CASE("a point at 45 degrees is at the edge of a 90 degree view", "[ui]") {
    const Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Perspective{90, 0.1f, 100}};
    const ProjectedPoint at =
        project(screen_map(camera, {600, 600}), {-3, 3, 2});  // 3 to the side, 3 up, 3 in front
    CHECK(distance(at.pixel, {0, 0}) < 1e-9);
    CHECK(at.depth == Approx(3));
    CHECK_FALSE(project(screen_map(camera, screen_picture), {0, 0, 6}).in_front);
}

TEST_CASE("unproject is the inverse of project for every projection", "[ui][property]") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const Camera& camera : cameras()) {
        const ScreenMap map = screen_map(camera, screen_picture);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 place{number(random), number(random), number(random)};
            const ProjectedPoint at = project(map, place);
            CHECK(glm::length(unproject(map, at.pixel, at.depth) - place) < 1e-9);
            const Ray ray = ray_through(map, at.pixel);
            CHECK(glm::length(glm::cross(place - ray.origin, ray.direction)) < 1e-9);
        }
    }
}

TEST_CASE("orbiting keeps distance, target and up, and never reaches a pole", "[ui][property]") {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> pixels(-500, 500);
    for (Camera camera : cameras()) {
        const Camera start = camera;
        for (int i = 0; i < 300; ++i) {
            orbit(camera, {pixels(random), pixels(random)}, screen_picture);
            CHECK(target_depth(camera) == Approx(target_depth(start)).epsilon(1e-4));
            const glm::vec3 out = glm::normalize(camera.eye - camera.target);
            CHECK(std::abs(glm::dot(out, glm::normalize(start.up))) < 0.9999f);
        }
        CHECK(camera.target == start.target);
        CHECK(camera.up == start.up);
    }
}

TEST_CASE("a drag over a quarter of the height turns the view by 90 degrees", "[ui]") {
    Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, {}};
    orbit(camera, {150, 0},
          screen_picture);  // to the right: the scene follows the cursor, so the eye moves left
    CHECK(camera.eye.x == Approx(-5));
    CHECK(camera.eye.z == Approx(0).margin(1e-5));
    camera.eye = {0, 0, 5};
    orbit(camera, {0, 75}, screen_picture);  // down: the eye goes up, by 45 degrees
    CHECK(camera.eye.y == Approx(3.5355339));
}

TEST_CASE("a panned point stays under the cursor", "[ui]") {
    for (const Camera& before : cameras()) {
        Camera camera = before;
        const glm::dvec3 held = unproject(screen_map(camera, screen_picture), {200, 450}, 4);
        pan(camera, {200, 450}, {333, 111}, 4, screen_picture);
        CHECK(distance(project(screen_map(camera, screen_picture), held).pixel, {333, 111}) < 1e-3);
        CHECK(glm::length((camera.eye - camera.target) - (before.eye - before.target)) < 1e-5);
    }
}

TEST_CASE("the point that the wheel moves towards stays under the cursor", "[ui]") {
    for (const Camera& before : cameras()) {
        Camera camera = before;
        const glm::dvec3 held = unproject(screen_map(camera, screen_picture), {100, 500}, 3);
        for (int i = 0; i < 5; ++i) {
            const double depth = project(screen_map(camera, screen_picture), held).depth;
            dolly(camera, {100, 500}, depth, 0.8, screen_picture);
        }
        CHECK(distance(project(screen_map(camera, screen_picture), held).pixel, {100, 500}) < 0.01);
        CHECK(glm::length(glm::normalize(camera.eye - camera.target) -
                          glm::normalize(before.eye - before.target)) < 1e-4);
    }
}

TEST_CASE("the wheel never moves the camera beyond the allowed coordinates", "[ui]") {
    for (Camera camera : cameras()) {
        for (int i = 0; i < 500; ++i) dolly(camera, {10, 10}, target_depth(camera), 0.7, screen_picture);
        CHECK(target_depth(camera) > 1e-5);
        for (int i = 0; i < 500; ++i) dolly(camera, {790, 10}, target_depth(camera), 1.5, screen_picture);
        CHECK(target_depth(camera) < 1e8);
        CHECK(project(screen_map(camera, screen_picture), camera.target).in_front);
    }
}

TEST_CASE("moving away widens the depth range, a near plane that cuts the scene stays", "[ui]") {
    const Bounds box{{-1, -1, -1}, {1, 1, 1}};
    Camera before{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Perspective{45, 1, 10}};
    Camera camera = before;
    camera.eye.z = 30;
    keep_depth_range(camera, before, box);
    CHECK(far_of(camera.projection) >= 31);
    camera.eye.z = 1.5f;
    keep_depth_range(camera, before, box);
    CHECK(near_of(camera.projection) < 0.5f);
    before.projection = Perspective{45, 5, 10};  // cuts the box
    camera = before;
    camera.eye.z = 3;
    keep_depth_range(camera, before, box);
    CHECK(camera.projection == before.projection);
}

TEST_CASE("a near plane already close to the eye does not move away from it", "[ui]") {
    const Camera before{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Perspective{45, 0.01f, 1000}};
    Camera camera = before;
    camera.eye.z = 1.005f;
    keep_depth_range(camera, before, {{-1, -1, -1}, {1, 1, 1}});
    CHECK(camera.projection == before.projection);
}

TEST_CASE("a frustum's window shrinks with its near plane, so the angle stays the same", "[ui]") {
    const Camera before{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Frustum{-0.5f, 0.25f, -0.125f, 0.75f, 1, 10}};
    Camera camera = before;
    camera.eye.z = 1.5f;
    keep_depth_range(camera, before, {{-1, -1, -1}, {1, 1, 1}});
    const Frustum& window = std::get<Frustum>(camera.projection);
    REQUIRE(window.near < 0.5f);
    CHECK(window.left == Approx(-0.5f * window.near));
    CHECK(window.right == Approx(0.25f * window.near));
    CHECK(window.bottom == Approx(-0.125f * window.near));
    CHECK(window.top == Approx(0.75f * window.near));
}
