// The terms that depend on normal, light and viewer, as in the lecture's review.
#include "renderer/reflectance/term_sensitivity.h"

#include <cmath>
#include <glm/geometric.hpp>

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
