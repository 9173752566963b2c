// The construction of r from n and l, with hand-computed numbers.
#include <glm/geometric.hpp>

#include "renderer/reflectance/highlight.h"
#include "tests/support/catch.h"

using namespace glint;

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
