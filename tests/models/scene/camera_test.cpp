// Numbers worked out by hand for eye (4,3,5), target (0,1,1), up (0,1,0), and frustum -1 2 -0.5 1.5 1 11.
#include <glm/vec4.hpp>

#include "models/scene/scene.h"
#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("view_from_world maps the eye to the origin and the target to -z", "[camera]") {
    const Camera camera{{4, 3, 5}, {0, 1, 1}, {0, 1, 0}, {}};
    const glm::dmat4 m = view_from_world(camera);
    const glm::dvec4 target = m * glm::dvec4(0, 1, 1, 1), p = m * glm::dvec4(1, 2, 3, 1);
    CHECK(target.z == Approx(-6));
    CHECK(std::abs(target.x) + std::abs(target.y) < 1e-12);
    CHECK(p.x == Approx(-0.70710678));
    CHECK(p.y == Approx(0.23570226));
    CHECK(p.z == Approx(-3.6666667));
    const glm::dmat4 identity = m * world_from_view(camera);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) CHECK(identity[c][r] == Approx(c == r ? 1 : 0).margin(1e-14));
}

TEST_CASE("an asymmetric frustum maps its six planes to -1 and +1", "[camera]") {
    const glm::dmat4 m = clip_from_view(Frustum{-1, 2, -0.5f, 1.5f, 1, 11}, {640, 480});
    const auto ndc = [&m](glm::dvec3 p) {
        const glm::dvec4 c = m * glm::dvec4(p, 1);
        return glm::dvec3(c) / c.w;
    };
    const glm::dvec3 low = ndc({-1, -0.5, -1}), high = ndc({22, 16.5, -11}), inside = ndc({0.5, 0.5, -2});
    for (int i = 0; i < 3; ++i) {
        CHECK(low[i] == Approx(-1));
        CHECK(high[i] == Approx(1));
    }
    CHECK(inside.x == Approx(-1.0 / 6));
    CHECK(inside.y == Approx(-0.25));
    CHECK(inside.z == Approx(0.1));
}

TEST_CASE("a perspective camera projects (1, 0.5, -5) to the expected pixel", "[camera]") {
    const glm::dmat4 m = clip_from_view(Perspective{45, 0.1f, 100}, {640, 480});
    const glm::dvec4 c = m * glm::dvec4(1, 0.5, -5, 1);
    CHECK((c.x / c.w + 1) * 320 == Approx(435.882251));
    CHECK((1 - c.y / c.w) * 240 == Approx(182.058875));
    CHECK(c.z / c.w == Approx(0.961962).epsilon(1e-6));
}
