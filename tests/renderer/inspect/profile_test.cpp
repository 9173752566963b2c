// Mach bands: compares the jump of intensity's first derivative at an edge with its closed form.
#include "renderer/debug_views/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/numbers.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr int pixels_per_unit = 200;
constexpr int width = 2 * pixels_per_unit, height = 20;
constexpr std::size_t edge = pixels_per_unit;  // the first pixel right of the middle edge

/// Two facets from x = -1 to 0 and 0 to 1, tilted by 10 degrees to either side, with vertex normals at -20, 0
/// and 20 degrees; a sun at 30 degrees; only k_d = 1 is used, so intensity is the cosine.
Scene strip(ShadingMode mode) {
    const auto back = static_cast<float>(-std::tan(10 * degree));
    auto mesh = std::make_shared<Mesh>();
    for (const float x : {-1.0f, 0.0f, 1.0f}) {
        const double turned = 20 * degree * static_cast<double>(x);
        for (const float y : {-1.0f, 1.0f}) {
            mesh->positions.emplace_back(x, y, x == 0 ? 0 : back);
            mesh->normals.emplace_back(std::sin(turned), 0, std::cos(turned));
        }
    }
    mesh->given_normals = GivenNormals::File;
    mesh->first_corner = {0, 4, 8};
    mesh->corner_position = {0, 2, 3, 1, 2, 4, 5, 3};
    finish_mesh(*mesh);

    Scene scene;
    scene.camera.projection = Orthographic{static_cast<float>(height) / pixels_per_unit, 0.1f, 100};
    scene.objects = {object_of(mesh)};
    scene.objects[0].material.diffuse = glm::vec3(1);
    scene.global_ambient = glm::vec3(0);
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {std::sin(30 * degree), 0, std::cos(30 * degree), 0};
    scene.lights = {sun};
    scene.shading.mode = mode;
    scene.shading.reflection = Reflection::Lambert;
    return scene;
}

std::vector<ProfileSample> across(const Scene& scene) {
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, {width, height}, true);
    return profile(renderer, picture, {0, height / 2}, {width - 1, height / 2});
}

double slope(const ProfileSample& s) { return *s.first_difference * pixels_per_unit; }

}  // namespace

TEST_CASE("profile: Gouraud shading's slope jumps at an edge as the closed form predicts", "[profile]") {
    const auto samples = across(strip(ShadingMode::Gouraud));
    const double left = slope(samples[edge - 50]), right = slope(samples[edge + 50]);
    CHECK(left == Approx(0.223238).margin(5e-5));
    CHECK(right == Approx(0.118782).margin(5e-5));
    // -2 k_d cos(30) (1 - cos(20)) / 1, entirely within the two samples at the edge.
    const double jump =
        (*samples[edge - 1].second_difference + *samples[edge].second_difference) * pixels_per_unit;
    CHECK(jump == Approx(-0.104455).margin(1e-4));
    CHECK(std::abs(*samples[edge - 20].second_difference) * pixels_per_unit < 1e-4);
    for (const std::size_t i : {edge - 1, edge}) {
        const auto measured = slope_jump_at(samples, i);
        REQUIRE(measured);
        CHECK((measured->after - measured->before) * pixels_per_unit == Approx(-0.104455).margin(1e-4));
    }
    CHECK_FALSE(slope_jump_at(samples, edge - 20));
}

TEST_CASE("a slope jump between two pixels is measured in full at both", "[profile]") {
    const auto line_with_jump = [](double at) {  // slopes 0.002 and 0.0077
        std::vector<ProfileSample> samples(40);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double x = static_cast<double>(i) - at;
            samples[i].intensity = 0.3 + 0.002 * x + (x > 0 ? 0.0057 * x : 0);
            if (i > 0) samples[i].first_difference = samples[i].intensity - samples[i - 1].intensity;
        }
        return samples;
    };
    for (const double t : {0.0, 0.05, 0.16, 0.5, 0.84, 0.95}) {
        const auto samples = line_with_jump(20 + t);
        CAPTURE(t);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const auto jump = slope_jump_at(samples, i);
            if (i < 19 || i > 21) CHECK_FALSE(jump);
            if (i != 20 && (i != 21 || t == 0)) continue;
            REQUIRE(jump);
            CHECK(jump->before == Approx(0.002));
            CHECK(jump->after == Approx(0.0077));
        }
    }
}

TEST_CASE("smooth curves and steps of the intensity have no slope jump", "[profile]") {
    for (const auto mode : {ShadingMode::Phong, ShadingMode::Flat}) {
        const auto samples = across(strip(mode));
        for (std::size_t i = 0; i < samples.size(); ++i) CHECK_FALSE(slope_jump_at(samples, i));
    }
}

TEST_CASE("profile: Phong shading's slope does not jump on a symmetric strip", "[profile]") {
    const auto samples = across(strip(ShadingMode::Phong));
    CHECK(slope(samples[edge - 1]) == Approx(0.171010).margin(1e-3));  // sin(20) sin(30)
    CHECK(slope(samples[edge + 1]) == Approx(0.171010).margin(1e-3));
    const double jump =
        (*samples[edge - 1].second_difference + *samples[edge].second_difference) * pixels_per_unit;
    CHECK(std::abs(jump) < 3e-3);  // the change of a smooth curve over two pixels
    CHECK(samples[edge / 2].intensity == Approx(0.766044).margin(1e-3));
    CHECK(samples[edge + edge / 2].intensity == Approx(0.939693).margin(1e-3));
}

TEST_CASE("profile: flat shading steps only at an edge", "[profile]") {
    const auto samples = across(strip(ShadingMode::Flat));
    CHECK(*samples[edge].first_difference == Approx(0.173648).margin(1e-5));
    for (std::size_t i = 1; i < samples.size(); ++i)
        if (i != edge) REQUIRE(*samples[i].first_difference == 0);
}

TEST_CASE("profile: a sample on a surface has a face, one on the background has none", "[profile]") {
    Scene scene = strip(ShadingMode::Phong);
    scene.camera.eye.x = scene.camera.target.x = 0.5f;  // a quarter of the picture is background
    const auto samples = across(scene);
    CHECK(samples.front().seen->face == 0);
    CHECK(samples[width / 4 - 1].seen->face == 0);
    CHECK(samples[width / 4].seen->face == 1);
    CHECK_FALSE(samples.back().seen);
    CHECK(samples.back().color == scene.display.background);
}

TEST_CASE("profile: samples are pixels of the picture, one per step along the longer axis", "[profile]") {
    const Scene scene = busy_scene();
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, {64, 48}, true);
    const auto samples = profile(renderer, picture, {60, 3}, {0, 43});
    REQUIRE(samples.size() == 61);
    CHECK(samples.front().pixel == glm::ivec2(60, 3));
    CHECK(samples.back().pixel == glm::ivec2(0, 43));
    CHECK(samples.back().position == Approx(std::hypot(60, 40)));
    for (const ProfileSample& s : samples) {
        REQUIRE(s.color == renderer.explain(s.pixel.x, s.pixel.y).sum);
        REQUIRE(s.pixel.y == std::lround(43 - 40.0 * s.pixel.x / 60));
    }
    CHECK_FALSE(samples.front().first_difference);
    CHECK_FALSE(samples.back().second_difference);
    CHECK(profile(renderer, picture, {5, 5}, {5, 5}).size() == 1);
}

TEST_CASE("profile: the intensity of a grey is its value", "[profile]") {
    CHECK(intensity_of(glm::vec3(0.3f)) == static_cast<double>(0.3f));
    CHECK(intensity_of({1, 0, 0}) == Approx(0.2126));
    CHECK(intensity_of({0, 1, 0}) == Approx(0.7152));
    CHECK(intensity_of({0, 0, 1}) == Approx(0.0722));
}

TEST_CASE("profile: the CSV has a named column for each number, empty if it has no value", "[profile]") {
    ProfileSample first, last;
    first.color = glm::vec3(0.5f);
    first.intensity = 0.5;
    last.pixel = {1, 0};
    last.position = 1;
    last.intensity = 0;
    last.first_difference = -0.5;
    last.seen = SeenPoint{2, 7, {}, {}};
    CHECK(profile_csv({first, last}) ==
          "position,r,g,b,intensity,first_difference,second_difference,face,object,x,y\n"
          "0,0.5,0.5,0.5,0.5,,,,,0,0\n"
          "1,0,0,0,0,-0.5,,7,2,1,0\n");
}

namespace {

/// Samples one pixel apart with these intensities.
template <class Intensity> std::vector<ProfileSample> made_up(int count, const Intensity& intensity) {
    std::vector<ProfileSample> samples(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        samples[static_cast<std::size_t>(i)].position = i;
        samples[static_cast<std::size_t>(i)].intensity = intensity(i);
    }
    return samples;
}

}  // namespace

TEST_CASE("profile: perceived brightness follows an even ramp and shows bands at bends", "[profile]") {
    const auto rise = made_up(200, [](int i) { return 0.1 + 0.002 * i; });
    const std::vector<double> seen_rise = perceived(rise, 12);
    for (std::size_t i = 0; i < rise.size(); ++i) CHECK(seen_rise[i] == Approx(rise[i].intensity));

    // A dark area, a ramp from 100 to 200 and a bright area: Mach's own figure.
    const auto ramp = made_up(300, [](int i) { return 0.2 + 0.006 * std::clamp(i - 100, 0, 100); });
    const std::vector<double> seen = perceived(ramp, 12);
    CHECK(seen[100] < ramp[100].intensity - 0.01);
    CHECK(seen[200] > ramp[200].intensity + 0.01);
    CHECK(seen[150] == Approx(ramp[150].intensity).margin(1e-4));
    CHECK(seen[20] == Approx(0.2));
    // At a change of slope by s the result is proportional to the mean of |x| under a Gaussian: s (wide -
    // narrow) / sqrt(2 pi).
    CHECK(ramp[100].intensity - seen[100] ==
          Approx(0.006 * (12 - 1) / std::sqrt(2 * std::numbers::pi)).epsilon(0.02));
    // Along a diagonal the samples are farther apart: the same bend per unit of distance gives the same band.
    auto diagonal =
        made_up(300, [](int i) { return 0.2 + 0.006 * std::numbers::sqrt2 * std::max(i - 150, 0); });
    for (ProfileSample& sample : diagonal) sample.position *= std::numbers::sqrt2;
    CHECK(diagonal[150].intensity - perceived(diagonal, 12)[150] ==
          Approx(0.006 * (12 - 1) / std::sqrt(2 * std::numbers::pi)).epsilon(0.02));
}
