// The properties that matter to each kind of light, against the lecture's table and hand-computed numbers.
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/reflectance/term_sensitivity.h"
#include "tests/support/catch.h"

using namespace glint;

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
    // Straight above the point, 2 away, 1 / r²: from 1/4 to 1 / 1.8².
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
    // r = n; v is 0.1 to the side at a distance of 1: the cosine is 1 / sqrt(1.01), to the power of 32.
    white.specular = glm::vec3(1);
    white.shininess = 32;
    CHECK(light_sensitivity(scene, light_picture, bulb, white, {0, 0, -4}, {0, 0, 1}).specular.viewer ==
          Approx(0.25 * (1 - std::pow(1.01, -16.0))).epsilon(1e-3));
}
