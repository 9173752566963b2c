// Limits of pictures: Lambert's formula for a polygon, a white furnace, and Phong shading, each approached at
// the expected rate.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize size{97, 73};

/// One white primitive under one light, seen from slightly above.
Scene white_under(const Light& light, Primitive kind, int detail) {
    Scene scene;
    scene.camera.eye = {1, 2, 3.5f};
    scene.global_ambient = {};
    scene.lights = {light};
    scene.objects = {object_of(primitive(kind, detail))};
    scene.objects[0].material.diffuse = glm::vec3(1);
    return scene;
}

/// The light received from a square of half-edge 1 at height 1 above the centre of a plane, as shown by the
/// centre pixel.
double seen_under_square(int samples, glm::vec3 turn) {
    Light square;
    square.kind = LightKind::Area;
    square.position = {0, 1, 0, 1};
    square.area = {{1, 0, 0}, {0, 0, 1}, samples};
    Scene scene = white_under(square, Primitive::Plane, 1);
    scene.objects[0].transform.rotate_deg = turn;
    scene.shading.reflection = Reflection::Lambert;
    Renderer renderer;
    return renderer.render(scene, size, true).linear_at(size.width / 2, size.height / 2).x;
}

}  // namespace

TEST_CASE("an area light gives the hand-computed sums of its samples", "[convergence][area]") {
    // The centre of the plane receives the sum over cells of A cos cos' / (pi n^2 r^2); formulas worked out
    // by hand, times 1 / pi.
    const double pi = std::numbers::pi;
    CHECK(seen_under_square(1, {}) == Approx(4.0 / pi));
    CHECK(seen_under_square(4, {}) == Approx(1.777778 / pi));
    CHECK(seen_under_square(9, {}) == Approx(1.794785 / pi));
    CHECK(seen_under_square(16, {}) == Approx(1.768973 / pi));
    CHECK(seen_under_square(64, {}) == Approx(1.747985 / pi));
}

namespace {

/// A white diffuse ball in a box whose six walls are area lights: mean and largest distance of its pixels
/// from 1.
std::pair<double, double> furnace(int samples) {
    Scene scene;
    scene.camera.eye = {0.4f, 0.6f, 1.5f};
    scene.global_ambient = {};
    scene.shading.reflection = Reflection::Lambert;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-2.0f, 2.0f}) {
            Light wall;
            wall.kind = LightKind::Area;
            wall.position = {0, 0, 0, 1};
            wall.position[axis] = side;
            wall.area = {glm::vec3(0), glm::vec3(0), samples};
            wall.area.edge_u[(axis + 1) % 3] = wall.area.edge_v[(axis + 2) % 3] = 2;
            scene.lights.push_back(wall);
        }
    scene.objects = {object_of(primitive(Primitive::Sphere, 64))};
    scene.objects[0].transform.scale = glm::vec3(0.5f);
    scene.objects[0].material.diffuse = glm::vec3(1);
    Renderer renderer;
    const Picture& picture = renderer.render(scene, size, true);
    double sum = 0, worst = 0;
    int count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (renderer.object_at(x, y) < 0) continue;
            const double off = std::abs(double{picture.linear_at(x, y).y} - 1);
            sum += off;
            worst = std::max(worst, off);
            ++count;
        }
    return {sum / std::max(count, 1), worst};
}

}  // namespace

TEST_CASE("a white diffuse ball in a white furnace is invisible", "[convergence][energy]") {
    // The light is equal from all directions, so a white surface reflects the same light, regardless of its
    // orientation. The remainder is the error of the samples at the centres of cells: it drops to a quarter
    // with four times as many.
    const auto [mean_16, worst_16] = furnace(16);
    const auto [mean_64, worst_64] = furnace(64);
    INFO("16 samples: " << mean_16 << ", " << worst_16 << "; 64: " << mean_64 << ", " << worst_64);
    CHECK(mean_64 < 5e-3);
    CHECK(worst_64 < 1e-2);
    CHECK(mean_16 / mean_64 == Approx(4).epsilon(0.1));
}

TEST_CASE("Gouraud converges to Phong with the square of an edge's length", "[convergence]") {
    // Linear interpolation of a smooth function is off by h^2/8 times its second derivative: halving h
    // quarters it.
    static constexpr PictureSize fine{291, 219};  // several pixels per cell of the finest ball
    const auto rms = [](int detail) {
        Light headlight;  // no terminator in view, where the second derivative is not finite
        headlight.space = LightSpace::Camera;
        headlight.position = {0, 0, 0, 1};
        Scene scene = white_under(headlight, Primitive::Sphere, detail);
        scene.objects[0].material.shininess = 8;
        scene.shading.mode = ShadingMode::Phong;
        Renderer phong, gouraud;
        const Picture& a = phong.render(scene, fine, true);
        scene.shading.mode = ShadingMode::Gouraud;
        const Picture& b = gouraud.render(scene, fine, true);
        double sum = 0;
        for (std::size_t i = 0; i < a.linear.size(); ++i)
            sum += std::pow(double{a.linear[i]} - b.linear[i], 2);
        return std::sqrt(sum / static_cast<double>(a.linear.size()));
    };
    for (const int detail : {32, 64, 128}) {
        const double order = std::log2(rms(detail) / rms(2 * detail));
        INFO("from " << detail << " slices on: order " << order);
        CHECK(order == Approx(2).margin(0.15));
    }
}
