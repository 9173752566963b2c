// The lighting equation against numbers worked out by hand or by other programs (OpenGL 2.1, section 2.14.1).
#include "renderer/lighting/illuminate.h"

#include <cmath>
#include <random>

#include "tests/support/catch.h"

using namespace glint;
using Vec = Vec3<float>;

namespace {

constexpr Equation phong_equation{Reflection::Phong, {}, nullptr};
constexpr Equation blinn_equation{Reflection::BlinnPhong, {}, nullptr};

LightAt<float> sun(Vec towards) {
    LightAt<float> light;
    light.xyz = towards;
    light.diffuse = light.specular = {1, 1, 1};
    return light;
}

MaterialAt<float> material(Vec k_d, Vec k_s, float shininess) {
    MaterialAt<float> m;
    m.k_d = k_d;
    m.k_s = k_s;
    m.shininess = shininess;
    return m;
}

}  // namespace

TEST_CASE("light from 60 degrees gives half the diffuse colour", "[lighting]") {
    // n = (0, 0, 1), l = (sqrt(3)/2, 0, 1/2): n.l = 1/2, so 0.8 / 2 = 0.4.
    const auto t = illuminate(phong_equation, sun({0.8660254f, 0, 0.5f}), material({0.8f, 0, 0}, {}, 32),
                              {{}, {0, 0, 1}, {0, 0, 1}});
    CHECK(t.diffuse.x == Approx(0.4f));
    CHECK(t.diffuse.y == 0);
}

TEST_CASE("r is l mirrored about n: a hand-computed example", "[lighting]") {
    // n = (1,2,2)/3, l = (2,1,2)/3: n.l = 8/9, r = (-2, 23, 14)/27.
    const auto t = illuminate(phong_equation, sun({2.0f / 3, 1.0f / 3, 2.0f / 3}), {},
                              {{}, {1.0f / 3, 2.0f / 3, 2.0f / 3}, {0, 0, 1}});
    CHECK(t.directions.n_dot_l == Approx(8.0 / 9));
    CHECK(t.directions.r.x == Approx(-2.0 / 27));
    CHECK(t.directions.r.y == Approx(23.0 / 27));
    CHECK(t.directions.r.z == Approx(14.0 / 27));
}

TEST_CASE("highlights of Phong and Blinn-Phong out of the plane of incidence", "[lighting]") {
    // n = (0,0,1), l = (.6,0,.8), v = (0,.6,.8): v.r = .64, n.h = 0.883452.
    const PointAt<float> at{{}, {0, 0, 1}, {0, 0.6f, 0.8f}};
    const auto light = sun({0.6f, 0, 0.8f});
    CHECK(illuminate(phong_equation, light, material({}, {1, 1, 1}, 10), at).specular.x ==
          Approx(0.0115292).epsilon(1e-4));
    CHECK(illuminate(blinn_equation, light, material({}, {1, 1, 1}, 10), at).specular.x ==
          Approx(0.289621).epsilon(1e-5));
    CHECK(illuminate(blinn_equation, light, material({}, {1, 1, 1}, 40), at).specular.x ==
          Approx(0.00703594).epsilon(1e-5));
}

TEST_CASE("a light behind the surface has no highlight, even for an even exponent", "[lighting]") {
    // 150 degrees from the normal: without the test n.l > 0 Blinn-Phong would give 0.330 and Phong 0.010.
    const PointAt<float> at{{}, {0, 0, 1}, {0, 0, 1}};
    const auto light = sun({0.5f, 0, -0.8660254f});
    for (const Equation& equation : {phong_equation, blinn_equation}) {
        const auto t = illuminate(equation, light, material({1, 1, 1}, {1, 1, 1}, 20), at);
        CHECK(t.diffuse.x == 0);
        CHECK(t.specular.x == 0);
    }
}

TEST_CASE("two lights in OpenGL's equation sum to the hand-computed colour", "[lighting][opengl]") {
    SurfaceMaterial m;
    m.k_a = {0.2f, 0.3f, 0.4f};
    m.k_d = {0.6f, 0.5f, 0.4f};
    m.k_s = {0.5f, 0.5f, 0.5f};
    m.shininess = 20;
    m.emission = {0.01f, 0.02f, 0.03f};
    m.global_ambient = {0.2f * 0.2f, 0.3f * 0.2f, 0.4f * 0.2f};
    LightSource lights[2];
    lights[0].xyz = {3, 4, -1};
    lights[0].w = 1;
    lights[0].ambient = {0.1f, 0.1f, 0.1f};
    lights[0].diffuse = {1, 0.9f, 0.8f};
    lights[0].specular = {1, 1, 1};
    lights[0].has_falloff = lights[0].has_cone = true;
    lights[0].constant = 1;
    lights[0].linear = 0.1f;
    lights[0].quadratic = 0.05f;
    lights[0].axis = {-0.57735027f, -0.57735027f, -0.57735027f};
    lights[0].cos_cutoff = 0.76604444f;  // 40 degrees
    lights[0].exponent = 3;
    lights[1].xyz = {0.57735027f, 0.57735027f, 0.57735027f};
    lights[1].ambient = {0, 0, 0.05f};
    lights[1].diffuse = {0.3f, 0.3f, 0.5f};
    lights[1].specular = {0.2f, 0.2f, 0.2f};
    LightJob job;
    job.lights = lights;
    job.light_count = 2;
    job.material = m;
    job.model = Reflection::BlinnPhong;
    const Vec p{1, 2, -5}, n{1.0f / 3, 2.0f / 3, 2.0f / 3};

    const Vec local = shade_point(job, seen_from_eye(job, p, n));
    CHECK(local.x == Approx(0.4093527).epsilon(1e-6));
    CHECK(local.y == Approx(0.3690836).epsilon(1e-6));
    CHECK(local.z == Approx(0.4317301).epsilon(1e-6));
    job.infinite_viewer = true;
    const Vec infinite = shade_point(job, seen_from_eye(job, p, n));
    CHECK(infinite.x == Approx(0.4311943).epsilon(1e-6));
    CHECK(infinite.y == Approx(0.3909251).epsilon(1e-6));
    CHECK(infinite.z == Approx(0.4535716).epsilon(1e-6));
}

TEST_CASE("falloff divides by c + b r + a r^2, and is 0 if that is 0", "[lighting]") {
    LightAt<float> light;
    light.constant = 1;
    light.linear = 0.1f;
    light.quadratic = 0.05f;
    CHECK(falloff(light, 4.0f) == Approx(0.454545).epsilon(1e-5));
    light.constant = light.linear = 0;
    light.quadratic = 1;
    CHECK(falloff(light, 2.0f) == Approx(0.25f));
    CHECK(falloff(light, 0.0f) == 0);
    CHECK(falloff(light, 1e-25f) == 0);  // its square is below the smallest normal float
}

TEST_CASE("a cone falls off as cos^exponent, includes its edge and ends there", "[lighting]") {
    LightAt<float> light;
    light.axis = {0, 0, -1};
    light.cos_cutoff = std::cos(30 * 0.0174532925f);
    light.exponent = 8;
    const auto at = [&light](double degrees) {
        const double a = degrees * 0.017453292519943295;
        return spot_factor(light, Vec{static_cast<float>(std::sin(a)), 0, static_cast<float>(std::cos(a))});
    };
    CHECK(at(0) == Approx(1));
    CHECK(at(20) == Approx(0.607976).epsilon(1e-5));
    CHECK(at(30) == Approx(0.316406).epsilon(1e-4));
    CHECK(at(30.1) == 0);
}

TEST_CASE("a spot's soft edge follows KHR_lights_punctual", "[lighting]") {
    LightAt<float> light;
    light.axis = {0, 0, -1};
    light.cos_cutoff = static_cast<float>(std::cos(0.4));
    light.exponent = 0;
    light.soft_edge = static_cast<float>(1 / (std::cos(0.3) - std::cos(0.4)));
    light.has_soft_edge = true;
    const auto at = [&light](double angle) {
        return spot_factor(light,
                           Vec{static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))});
    };
    for (const double inside : {0.0, 0.13, 0.28, 0.2999}) CHECK(at(inside) == Approx(1));
    CHECK(at(0.379) == Approx(0.054125).epsilon(1e-3));  // by the sample code of the extension
    CHECK(at(0.4001) == 0);
    light.exponent = 2;
    CHECK(at(0.28) == Approx(std::pow(std::cos(0.28), 2)));
}

TEST_CASE("a light at the point itself contributes only its ambient share", "[lighting]") {
    LightAt<float> light = sun({1, 2, 3});
    light.w = 1;
    light.ambient = {0.5f, 0.5f, 0.5f};
    light.constant = 2;
    light.has_falloff = true;
    MaterialAt<float> m = material({1, 1, 1}, {1, 1, 1}, 0);
    m.k_a = {1, 1, 1};
    const auto t = illuminate(phong_equation, light, m, {{1, 2, 3}, {0, 0, 1}, {0, 0, 1}});
    CHECK(t.diffuse.x == 0);
    CHECK(t.specular.x == 0);
    CHECK(t.ambient.x == Approx(0.25));
}

TEST_CASE("red light on a green surface is black", "[lighting]") {
    LightAt<float> light = sun({0, 0, 1});
    light.diffuse = {1, 0, 0};
    const auto t = illuminate(phong_equation, light, material({0, 1, 0}, {}, 1), {{}, {0, 0, 1}, {0, 0, 1}});
    CHECK(t.diffuse.x == 0);
    CHECK(t.diffuse.y == 0);
    CHECK(t.diffuse.z == 0);
}

TEMPLATE_TEST_CASE("r leaves the surface at the angle at which l arrives", "[lighting][property]", float,
                   Lanes<4>) {
    using F = TestType;
    std::mt19937 random(7);
    const auto number = [&random] { return F(static_cast<float>(random() % 20001) * 1e-4f - 1.0f); };
    const auto vector = [&] {
        const F x = number(), y = number();
        return Vec3<F>{x, y, number() + F(1e-3f)};
    };
    for (int i = 0; i < 1000; ++i) {
        const Vec3<F> n = unit(vector());
        LightAt<F> light;
        light.xyz = unit(vector());
        const auto t = illuminate<F>(phong_equation, light, {}, {{}, n, n});
        CHECK(lane(dot(t.directions.r, n), 0) == Approx(lane(t.directions.n_dot_l, 0)).margin(1e-5));
        CHECK(lane(length(t.directions.r), 0) == Approx(1).margin(1e-5));
    }
}
