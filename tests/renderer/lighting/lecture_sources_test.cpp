// Compares the lecture's light sources, each in its own scene, with closed forms and hand-computed numbers.
#include <numbers>

#include "models/numbers.h"
#include "tests/support/lecture_scene.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

/// A white 2 x 2 plate in z = 0 that faces +z, seen perpendicularly; the centre pixel of {101, 101} shows the
/// origin.
Scene white_plate() {
    Scene scene;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    scene.global_ambient = glm::vec3(0);
    scene.shading.reflection = Reflection::Lambert;
    scene.objects = {object_of(primitive(Primitive::Plane, 1))};
    scene.objects[0].transform.rotate_deg.x = 90;
    scene.objects[0].material.diffuse = glm::vec3(1);
    return scene;
}

double middle_value(const Scene& scene) {
    Renderer renderer(1);
    return renderer.render(scene, {101, 101}, true).linear_at(50, 50).x;
}

Light area_light(glm::vec3 place, glm::vec3 u, glm::vec3 v, int samples) {
    Light light;
    light.kind = LightKind::Area;
    light.position = glm::vec4(place, 1);
    light.area = {u, v, samples};
    return light;
}

}  // namespace

TEST_CASE("a point is lit although another object is in front of its light", "[lecture]") {
    Scene scene = lecture_scene("no-shadows");
    const glm::dvec3 below_the_ball{0, -0.2, 0.2};
    const Drawn with(scene);
    REQUIRE(with.at(below_the_ball).object_index == 2);
    CHECK(with.at(below_the_ball).at.lights[0].diffuse.x > 0.3f);
    scene.objects.erase(scene.objects.begin());
    CHECK(with.colour(below_the_ball) == Drawn(scene).colour(below_the_ball));
}

TEST_CASE("an area light converges to Lambert's polygon formula with 1 to 64 samples", "[lecture]") {
    // A square [-1, 1]^2 at z = 1 faces the receiver. E / (pi L) by midpoints is 4, 1.777778, 1.768973 and
    // 1.747985 over pi for 1, 4, 16 and 64 samples; in the limit 2 sqrt(2) atan(1 / sqrt(2)) / pi.
    Scene scene = white_plate();
    const double limit = 2 * std::sqrt(2.0) * std::atan(1 / std::sqrt(2.0)) / std::numbers::pi;
    double last_error = 1;
    const std::pair<int, double> rows[] = {{1, 4}, {4, 1.777778}, {16, 1.768973}, {64, 1.747985}};
    for (const auto& [samples, pi_times] : rows) {
        CAPTURE(samples);
        scene.lights = {area_light({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, samples)};
        const double value = middle_value(scene);
        CHECK(value == Approx(pi_times / std::numbers::pi).epsilon(1e-4));
        CHECK(std::abs(value - limit) < last_error);
        last_error = std::abs(value - limit);
    }
    // A wall at x = 2, with y from -1 to 1 and z from -1 to 2, partly below the horizon, gives 0.2233466 /
    // pi.
    scene.lights = {area_light({2, 0, 0.5f}, {0, 1, 0}, {0, 0, 1.5f}, 64)};
    CHECK(middle_value(scene) == Approx(0.2233466 / std::numbers::pi).epsilon(0.03));
}

TEST_CASE("a world light stays with the scene, a camera light with the orbiting viewer", "[lecture]") {
    Scene scene;
    scene.objects = {object_of(primitive(Primitive::Sphere, 96))};
    Light sun, headlight;
    sun.kind = headlight.kind = LightKind::Directional;
    sun.position = {1, 0, 0, 0};
    headlight.position = {0.6f, 0, 0.8f, 0};
    headlight.space = LightSpace::Camera;
    scene.lights = {sun, headlight};
    for (const double turn : {0.0, 30.0, 60.0, 90.0, 200.0}) {
        CAPTURE(turn);
        scene.camera.eye = {5 * std::sin(turn * degree), 0, 5 * std::cos(turn * degree)};
        const Explanation e = Drawn(scene, {101, 101}).at(50, 50);  // the point nearest to the eye
        CHECK(e.at.lights[0].n_dot_l == Approx(std::sin(turn * degree)).margin(2e-3));
        CHECK(e.at.lights[1].n_dot_l == Approx(0.8).margin(2e-3));
    }
}

TEST_CASE("the same power spread over areas of 1, 4 and 9 gives 1, 1/4 and 1/9 of the light", "[lecture]") {
    const Drawn drawn(lecture_scene("inverse-square"), {640, 360});
    for (const int d : {1, 2, 3}) {
        CAPTURE(d);
        // A point low on the plate and to the front, where no nearer plate blocks the view; r^2 = d^2 (1 +
        // 0.15^2 + 0.2^2).
        const glm::dvec3 place{-2.4 + d, -0.15 * d, 0.2 * d};
        const double r = d * std::sqrt(1 + 0.15 * 0.15 + 0.2 * 0.2);
        const Explanation e = drawn.at(place);
        REQUIRE(e.object_index == d - 1);
        CHECK(e.at.lights[0].diffuse.x == Approx(d / (r * r * r)).epsilon(0.02));
    }
}

TEST_CASE("1 / (1 + r^2 / R^2) matches a head-on disc of radius R, and nearly a square", "[lecture]") {
    Scene scene = white_plate();
    const float half_edge = std::sqrt(std::numbers::pi_v<float>) / 2;  // R = 1
    for (const float r : {1.5f, 2.0f, 3.0f, 5.0f}) {
        CAPTURE(r);
        const double disc = 1 / (1.0 + r * r);  // form factor R^2 / (R^2 + r^2)
        Light bulb;
        bulb.position = {0, 0, r, 1};
        bulb.falloff = {1, 0, 1};
        scene.lights = {bulb};
        CHECK(middle_value(scene) == Approx(disc).epsilon(1e-5));
        scene.lights = {area_light({0, 0, r}, {half_edge, 0, 0}, {0, half_edge, 0}, 64)};
        CHECK(middle_value(scene) == Approx(disc).epsilon(0.011));
    }
}

TEST_CASE("a constant ambient light is as bright deep in a corner as at the corner's edge", "[lecture]") {
    Scene scene = lecture_scene("ambient-in-a-corner");
    scene.objects.pop_back();
    const Drawn drawn(scene);
    const Explanation deep = drawn.at({-1.1, 0, 0}), edge = drawn.at({1.1, 0, 0});
    REQUIRE(deep.object_index == 1);
    REQUIRE(edge.object_index == 1);
    CHECK(deep.at.global_ambient == edge.at.global_ambient);
    CHECK(deep.at.global_ambient.x == Approx(0.8 * 0.25));
    CHECK(deep.sum.x == Approx(edge.sum.x).epsilon(1e-6));  // no light bounces off the red plate
}
