// Compares the three kinds of interpolation with hand-computed numbers.
#include <cmath>
#include <random>

#include "renderer/geometry/interpolate.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

/// Corner values shown unchanged, seen from +z without perspective.
Scene values_scene(MeshPtr mesh, float view_height) {
    Scene scene;
    scene.objects.push_back(object_of(std::move(mesh)));
    scene.shading.reflection = Reflection::None;
    scene.shading.mode = ShadingMode::Gouraud;
    scene.camera.projection = Orthographic{view_height, 0.1f, 100};
    return scene;
}

float value_at(const Scene& scene, PictureSize size, int x, int y) {
    Renderer renderer(1);
    return renderer.render(scene, size, true).linear_at(x, y).x;
}

}  // namespace

TEST_CASE("weights at a screen point: perspective-correct compared with screen-linear", "[interpolation]") {
    // w = 1, 2, 4 and screen weights .2, .3, .5: correct weights (0.421053, 0.315789, 0.263158).
    const ClipCorner<float> a{-0.8f, -0.6f, 1}, b{2 * 0.7f, 2 * -0.5f, 2}, c{4 * 0.1f, 4 * 0.9f, 4};
    const ScreenPoint<float> at{0.2f * -0.8f + 0.3f * 0.7f + 0.5f * 0.1f,
                                0.2f * -0.6f + 0.3f * -0.5f + 0.5f * 0.9f};
    const Vec3<float> w = perspective_weights(a, b, c, at);
    CHECK(w.x == Approx(0.421053).epsilon(1e-5));
    CHECK(w.y == Approx(0.315789).epsilon(1e-5));
    CHECK(w.z == Approx(0.263158).epsilon(1e-5));
    const Vec3<float> s = screen_weights(w, 1.0f, 2.0f, 4.0f);
    CHECK(s.x == Approx(0.2).epsilon(1e-5));
    CHECK(s.y == Approx(0.3).epsilon(1e-5));
    CHECK(s.z == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("scanline interpolation of a skew quad depends on its rotation", "[interpolation][lecture]") {
    // Quad A(0,0)=0 B(4,0)=1 C(6,4)=0 D(0,4)=1; its centre P(3,2) is fixed at the picture's centre.
    const struct {
        float turn, value;
    } rows[] = {{0, 0.5f},       {90, 0.625f},    {-90, 0.625f},   {45, 0.833333f},
                {60, 0.833333f}, {15, 0.648808f}, {30, 0.795268f}, {75, 0.736645f}};
    Scene scene = values_scene(primitive(Primitive::SkewQuad, 1), 10);
    for (const auto& row : rows) {
        scene.objects[0].transform.rotate_deg.z = row.turn;
        CAPTURE(row.turn);
        scene.shading.interpolation = Interpolation::Scanline;
        CHECK(value_at(scene, {101, 101}, 50, 50) == Approx(row.value).epsilon(1e-4));
        // If the quad is cut into ABC and ACD, P is on AC, whose two ends are 0, for every rotation.
        scene.shading.interpolation = Interpolation::Perspective;
        CHECK(value_at(scene, {101, 101}, 50, 50) == Approx(0).margin(1e-4));
        scene.shading.interpolation = Interpolation::Screen;
        CHECK(value_at(scene, {101, 101}, 50, 50) == Approx(0).margin(1e-4));
    }
}

TEST_CASE("extra corners on straight edges do not change scanline interpolation", "[interpolation]") {
    // The skew quad of the previous test with each edge cut into 40 pieces.
    constexpr int pieces = 40;
    const std::array<glm::vec2, 4> quad{glm::vec2(0, 0), glm::vec2(4, 0), glm::vec2(6, 4), glm::vec2(0, 4)};
    std::vector<glm::vec3> positions, colors;
    std::vector<std::uint32_t> face;
    for (std::size_t edge = 0; edge < 4; ++edge)
        for (int i = 0; i < pieces; ++i) {
            const float t = float(i) / pieces, value = edge % 2 == 0 ? t : 1 - t;
            positions.emplace_back(glm::mix(quad[edge], quad[(edge + 1) % 4], t) - glm::vec2(3, 2), 0);
            colors.emplace_back(value);
            face.push_back(static_cast<std::uint32_t>(face.size()));
        }
    Mesh mesh = make_mesh(positions, {face});
    mesh.colors = colors;
    Scene scene = values_scene(std::make_shared<const Mesh>(std::move(mesh)), 0.1f);
    scene.shading.interpolation = Interpolation::Scanline;
    Renderer renderer(1);
    constexpr PictureSize one_row{101, 1};  // so that every frame begins where the last one ended
    const std::array<std::array<float, 2>, 5> rows{
        {{0, 0.5f}, {90, 0.625f}, {45, 0.833333f}, {15, 0.648808f}, {0, 0.5f}}};
    for (const auto& [turn, value] : rows) {
        scene.objects[0].transform.rotate_deg.z = turn;
        CAPTURE(turn);
        CHECK(renderer.render(scene, one_row, true).linear_at(50, 0).x == Approx(value).epsilon(1e-4));
    }
}

TEST_CASE("a vertex shared on only one side makes a step on the crossing scanline",
          "[interpolation][lecture][release]") {
    // The slide's A..H: 8 x 8, centred, so that the shared edge is x = 4 at 0. 801 pixels over 8.01 units:
    // the sample at column 400 + 100 k is at x = k; the pixels to the left and right of 0 straddle the edge.
    const PictureSize size{801, 801};
    const auto picture_of = [&size](int detail) {
        Scene scene = values_scene(primitive(Primitive::TJunction, detail), 8.01f);
        scene.shading.interpolation = Interpolation::Scanline;
        Renderer renderer(1);
        return renderer.render(scene, size, true);
    };
    const Picture pictures[] = {picture_of(1), picture_of(2)};
    const auto value = [&pictures](int detail, double x, double y, double side) {
        const int column = static_cast<int>(std::lround(400 + 100 * (x - 4) + side));
        const int row = static_cast<int>(std::lround(400 - 100 * (y - 4)));
        return pictures[detail - 1].linear_at(column, row).x;
    };
    CHECK(value(1, 2, 6, 0) == Approx(0.3).margin(2e-3));
    CHECK(value(1, 4, 6, -1) == Approx(0.4).margin(3e-3));
    CHECK(value(1, 4, 6, 1) == Approx(0.65).margin(3e-3));
    CHECK(value(1, 6, 6, 0) == Approx(0.625).margin(2e-3));
    for (const auto& [y, step] : {std::pair{2.0, 0.25}, {4.0, 0.5}, {6.0, 0.25}}) {
        CAPTURE(y);
        CHECK(value(1, 4, y, 1) - value(1, 4, y, -1) == Approx(step).margin(6e-3));
        CHECK(std::abs(value(2, 4, y, 1) - value(2, 4, y, -1)) < 6e-3);  // B shared by both sides: no step
    }
}

TEST_CASE("on a receding quad, screen and correct interpolation differ as computed by hand",
          "[interpolation][release]") {
    // A strip from w = 1 (value 0) to w = 3 (value 1): at screen fractions .25, .5, .75 the values are .1,
    // .25, .5; screen-linear values are the fractions themselves.
    auto mesh = std::make_shared<Mesh>(*polygon_mesh(
        {{-0.5f, -0.5f, -1}, {-0.5f, 0.5f, -1}, {1.5f, 1.5f, -3}, {1.5f, -1.5f, -3}}, {{0, 3, 2, 1}}));
    mesh->colors = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}};
    Scene scene = values_scene(mesh, 1);
    scene.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, Frustum{-0.05f, 0.05f, -0.05f, 0.05f, 0.1f, 10}};
    const PictureSize size{401, 401};  // x from -0.5 (fraction 0) to 0.5 (fraction 1)
    for (const auto& [share, correct] : {std::pair{0.25, 0.1}, {0.5, 0.25}, {0.75, 0.5}}) {
        const int x = static_cast<int>(std::lround(401 * share - 0.5));
        CAPTURE(share);
        scene.shading.interpolation = Interpolation::Perspective;
        CHECK(value_at(scene, size, x, 200) == Approx(correct).margin(2e-3));
        scene.shading.interpolation = Interpolation::Screen;
        CHECK(value_at(scene, size, x, 200) == Approx(share).margin(2e-3));
        scene.shading.interpolation = Interpolation::Scanline;
        CHECK(value_at(scene, size, x, 200) == Approx(share).margin(2e-3));
    }
}

TEST_CASE("screen interpolation of a quad through the near plane starts at the cut", "[interpolation]") {
    // The ground extends from z = 1 (behind the eye, value 0) to z = -3 (value 1), 1 below the eye. The near
    // plane cuts it at z = -0.5, where the value is 0.375.
    auto mesh = std::make_shared<Mesh>(
        *polygon_mesh({{-9, -1, 1}, {9, -1, 1}, {9, -1, -3}, {-9, -1, -3}}, {{0, 1, 2, 3}}));
    mesh->colors = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}};
    Scene scene = values_scene(mesh, 1);
    scene.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, Frustum{-0.5f, 0.5f, -1.25f, 0, 0.5f, 10}};
    const PictureSize size{101, 250};  // y: 0 at the horizon, -2.5 at the bottom, in units of slope
    for (const Interpolation how : {Interpolation::Screen, Interpolation::Scanline}) {
        scene.shading.interpolation = how;
        // Slope -2 (the cut) has the value 0.375, slope -1/3 (the far edge) the value 1; linear between.
        for (const int row : {50, 100, 150, 190}) {
            const double slope = -(row + 0.5) / 100, share = (slope + 2) / (2 - 1.0 / 3);
            CAPTURE(row);
            CHECK(value_at(scene, size, 50, row) == Approx(0.375 + 0.625 * share).margin(2e-3));
        }
        CHECK(value_at(scene, size, 50, 210) == Approx(scene.display.background.x));  // nearer than the cut
    }
}

TEST_CASE("a glow equal at all corners is equal at every pixel of a cut or stretched face",
          "[interpolation]") {
    constexpr float glow = 0.4375f;
    std::mt19937 random(7);
    Scene scene = values_scene(primitive(Primitive::Torus, 6), 1);
    scene.objects[0].material.emission = glm::vec3(glow);
    scene.objects[0].material.ambient = glm::vec3(0);
    scene.shading.reflection = Reflection::Lambert;
    scene.display.background = glm::vec3(0);
    Renderer renderer(1);
    int covered = 0, others = 0;
    for (int i = 0; i < 300; ++i) {
        const auto number = [&] { return uniform(random, -1, 1); };
        Transform& transform = scene.objects[0].transform;
        transform.translate = {number(), number(), number()};
        transform.rotate_deg = 180.0f * glm::vec3(number(), number(), number());
        transform.scale = {3, std::pow(10.0f, 3.5f * (1 + number())), 1000};
        scene.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, Perspective{100, 0.1f, 1e7f}};
        for (const Interpolation how :
             {Interpolation::Perspective, Interpolation::Screen, Interpolation::Scanline}) {
            scene.shading.interpolation = how;
            const Picture picture = renderer.render(scene, {64, 48}, true);
            for (std::size_t pixel = 0; pixel < picture.size.pixels(); ++pixel) {
                const float shown = picture.linear[3 * pixel];
                covered += shown != 0 ? 1 : 0;
                others += shown != 0 && std::abs(shown - glow) > 1e-6f ? 1 : 0;
            }
        }
    }
    CHECK(covered > 10'000);
    CHECK(others == 0);
}
