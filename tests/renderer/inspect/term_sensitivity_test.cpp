// The terms that depend on normal, light and viewer, as in the lecture's review.
#include "renderer/reflectance/term_sensitivity.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/reflectance/highlight.h"
#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("ambient depends on nothing, diffuse on normal and light, specular on all three",
          "[lighting][why]") {
    const glm::vec3 n = glm::normalize(glm::vec3(0.2f, 0.3f, 1)),
                    l = glm::normalize(glm::vec3(-0.5f, 0.4f, 1));
    const glm::vec3 v = glm::normalize(glm::vec3(0.6f, 0.3f, 1));
    for (const Reflection model : {Reflection::Phong, Reflection::BlinnPhong}) {
        const auto [ambient, diffuse, specular] = term_sensitivity({model, Material{}, Terms{}}, n, l, v);
        CHECK(ambient.normal == 0);
        CHECK(ambient.light == 0);
        CHECK(ambient.viewer == 0);
        CHECK(diffuse.normal > 0);
        CHECK(diffuse.light > 0);
        CHECK(diffuse.viewer == 0);
        CHECK(specular.normal > 0);
        CHECK(specular.light > 0);
        CHECK(specular.viewer > 0);
    }
}

TEST_CASE("one more degree at 60 degrees lowers the diffuse term by sin 60 times a degree",
          "[lighting][why]") {
    const float s = std::sqrt(3.0f) / 2;
    Material white;
    white.diffuse = glm::vec3(1);
    const auto sensitivity =
        term_sensitivity({Reflection::Lambert, white, Terms{}}, {0, 0, 1}, {-s, 0, 0.5f}, {0, 0, 1});
    CHECK(sensitivity[1].light == Approx(double(s) * 3.14159265 / 180).epsilon(0.01));
    CHECK(sensitivity[2].viewer == 0);
}

TEST_CASE("with the light behind the surface, no term depends on anything", "[lighting][why]") {
    const auto needs =
        term_sensitivity({Reflection::Phong, Material{}, Terms{}}, {0, 0, 1}, {0.8f, 0, -0.6f}, {0, 0, 1});
    for (const TermSensitivity& need : needs) CHECK(need.normal + need.light + need.viewer == 0);
}

// Compares what matters to each kind of light with the lecture's table and with hand-computed numbers.
namespace {

const PictureSize light_picture{100, 100};
const glm::vec3 place{0.2f, -0.1f, -4};
const glm::vec3 normal = glm::normalize(glm::vec3(0.1f, 0.3f, 1));

/// In camera coordinates, so that no camera transform is involved.
Light light_of(LightKind kind) {
    Light light;
    light.kind = kind;
    light.space = LightSpace::Camera;
    light.position = {0.5f, 1.2f, -2, 1};
    if (kind == LightKind::Directional) light.position = {glm::vec3(light.position) - place, 0};
    light.falloff = {1, 0.1f, 0.2f};
    light.spot.direction = place - glm::vec3(light.position);
    light.spot.cutoff_deg = 40;
    light.spot.exponent = 5;
    return light;
}

LightSensitivity sensitivity_of(LightKind kind, bool local_viewer = true) {
    Scene scene;
    scene.shading.local_viewer = local_viewer;
    return light_sensitivity(scene, light_picture, light_of(kind), Material{}, place, normal);
}

}  // namespace

TEST_CASE("light sensitivity matches the lecture's table, which omits a sun's highlight", "[lighting][why]") {
    for (const LightKind kind :
         {LightKind::Directional, LightKind::Point, LightKind::Spot, LightKind::Area}) {
        INFO(static_cast<int>(kind));
        const LightSensitivity sensitivity = sensitivity_of(kind);
        CHECK((sensitivity.diffuse.light > 0) == (kind != LightKind::Directional));
        CHECK(sensitivity.diffuse.viewer == 0);
        CHECK(sensitivity.diffuse.surface > 0);
        CHECK((sensitivity.specular.light > 0) == (kind != LightKind::Directional));
        CHECK(sensitivity.specular.viewer > 0);  // the table calls it unimportant for a sun
        CHECK(sensitivity.specular.surface > 0);
    }
}

TEST_CASE("a highlight does not depend on the position of a viewer at infinity", "[lighting][why]") {
    CHECK(sensitivity_of(LightKind::Point, false).specular.viewer == 0);
    CHECK(sensitivity_of(LightKind::Point, false).specular.light > 0);
}

TEST_CASE("the changes of terms match hand-computed values", "[lighting][why]") {
    Scene scene;
    Light bulb = light_of(LightKind::Point);
    // A light at distance 2 from the point, with falloff 1 / r²: moving 0.2 closer changes 1/4 to 1 / 1.8².
    bulb.position = {0, 0, -2, 1};
    bulb.falloff = {0, 0, 1};
    Material white;
    white.diffuse = glm::vec3(1);
    const LightSensitivity sensitivity =
        light_sensitivity(scene, light_picture, bulb, white, {0, 0, -4}, {0, 0, 1});
    CHECK(sensitivity.falloff == Approx(0.25));
    CHECK(sensitivity.spot == 1);
    CHECK(sensitivity.diffuse.light == Approx(1 / (1.8 * 1.8) - 0.25));
    CHECK(sensitivity.diffuse.surface == Approx(0.25 * (1 - std::cos(3.14159265 / 180))).epsilon(0.01));
    // r = n; moving v sideways by 0.1 changes the cosine from 1 to 1 / sqrt(1.01); the exponent is 32.
    white.specular = glm::vec3(1);
    white.shininess = 32;
    CHECK(light_sensitivity(scene, light_picture, bulb, white, {0, 0, -4}, {0, 0, 1}).specular.viewer ==
          Approx(0.25 * (1 - std::pow(1.01, -16.0))).epsilon(1e-3));
}

// The construction of r from n and l, with hand-computed numbers.
TEST_CASE("r by hand: the projection of l from 60 degrees is half of n", "[lighting][why]") {
    const float s = std::sqrt(3.0f) / 2;
    const MirrorSteps steps = mirror_steps({0, 0, 1}, {-s, 0, 0.5f});
    CHECK(steps.n_dot_l == Approx(0.5f));
    CHECK(glm::distance(steps.p, {0, 0, 0.5f}) < 1e-6f);
    CHECK(glm::distance(steps.twice_p, {0, 0, 1}) < 1e-6f);
    CHECK(glm::distance(steps.r, {s, 0, 0.5f}) < 1e-6f);
}

TEST_CASE("a normal twice as long makes P four times too long, and r not a unit vector", "[lighting][why]") {
    const glm::vec3 l{0.6f, 0, 0.8f};
    const MirrorSteps right = mirror_steps({0, 0, 1}, l), wrong = mirror_steps({0, 0, 2}, l);
    CHECK(glm::length(wrong.p) == Approx(4 * glm::length(right.p)));
    CHECK(glm::length(right.r) == Approx(1));
    CHECK(glm::length(wrong.r) > 5);
}
