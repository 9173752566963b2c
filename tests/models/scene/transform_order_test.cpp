// An object's transforms written in every order: the same matrix, or nothing if a scene file cannot express
// it.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "models/scene/scene.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

/// OpenGL's matrix after the three calls, by GLM: each multiplies from the right.
glm::dmat4 product(const Transform& t, const TransformOrder& order) {
    glm::dmat4 m(1);
    for (const TransformStep step : order) {
        if (step == TransformStep::Translate) m = glm::translate(m, glm::dvec3(t.translate));
        if (step == TransformStep::Scale) m = glm::scale(m, glm::dvec3(t.scale));
        if (step == TransformStep::Rotate) {
            const glm::dvec3 angle = glm::radians(glm::dvec3(t.rotate_deg));
            m = glm::rotate(m, angle.z, {0, 0, 1});
            m = glm::rotate(m, angle.y, {0, 1, 0});
            m = glm::rotate(m, angle.x, {1, 0, 0});
        }
    }
    return m;
}

}  // namespace

TEST_CASE("a transform in any order has a file-order transform with the same matrix", "[transform]") {
    std::mt19937 random(5);
    const auto number = [&random] { return static_cast<float>(random() % 2001) / 100 - 10; };
    for (int i = 0; i < 200; ++i) {
        const float scale = number() + 0.003f;
        const Transform written{{number(), number(), number()},
                                {9 * number(), 9 * number(), 9 * number()},
                                {scale, scale, scale}};
        for (TransformOrder order = file_order;;) {
            const auto transform = in_file_order(written, order);
            REQUIRE(transform);
            const glm::dmat4 expected = product(written, order), found = world_from_object(*transform);
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r) CHECK(found[c][r] == Approx(expected[c][r]).margin(2e-5));
            if (!std::next_permutation(order.begin(), order.end())) break;
        }
    }
}

TEST_CASE("a scale along axes that a rotation turns cannot precede that rotation", "[transform]") {
    using enum TransformStep;
    const Transform shears{{1, 2, 3}, {0, 0, 30}, {1, 2, 1}};
    CHECK_FALSE(in_file_order(shears, {Scale, Rotate, Translate}));
    CHECK_FALSE(in_file_order(shears, {Scale, Translate, Rotate}));
    CHECK(in_file_order(shears, {Rotate, Scale, Translate}));
    // A rotation about the axis of the scale, or no rotation, causes no shear.
    CHECK(in_file_order({{1, 2, 3}, {0, 40, 0}, {1, 2, 1}}, {Scale, Rotate, Translate}));
    CHECK(in_file_order({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}}, {Scale, Translate, Rotate}));
    CHECK(in_file_order(shears, file_order) == shears);
}
