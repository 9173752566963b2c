// Compares the lighting equation with numbers worked out by hand or by other programs (OpenGL 2.1, section
// 2.14.1).
#include "renderer/lighting/illuminate.h"

#include <cmath>
#include <random>
#include <vector>

#include "renderer/renderer.h"
#include "renderer/simd/pow.h"
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
    // At 150 degrees from the normal, without the test n.l > 0, Blinn-Phong would give 0.330 and Phong 0.010.
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

TEST_CASE("a light at the point itself contributes only its ambient term", "[lighting]") {
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

// Compares power() with the library's pow in double, and its bits in vectors of every width.
TEST_CASE("power is within a relative 2.5e-6 of pow for results above 1e-6", "[power]") {
    std::mt19937 random(11);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const float x = static_cast<float>(random() % 1000001) * 1e-6f;
        const float s = static_cast<float>(random() % 100001) * 0.01f;
        const double exact = std::pow(static_cast<double>(x), static_cast<double>(s));
        if (exact < 1e-6) continue;  // smaller results lose one more digit and are invisible
        worst = std::max(worst, std::abs(power(x, s) / exact - 1));
    }
    CHECK(worst < 2.5e-6);
}

TEST_CASE("squaring gives every whole power up to 1024 within 2^-24 of pow per factor", "[power]") {
    std::mt19937 random(3);
    for (int n = 0; n <= 1024; ++n) {
        const Exponent<float> s = static_cast<float>(n);
        REQUIRE(s.whole == n);
        for (int i = 0; i < 200; ++i) {
            // x such that x^n is spread from 2^-24, the smallest visible highlight, to 1
            const double wanted = std::exp2(-24.0 * static_cast<double>(random() % 1000001) * 1e-6);
            const auto x = static_cast<float>(std::pow(wanted, 1.0 / std::max(n, 1)));
            const double exact = std::pow(static_cast<double>(x), n);
            REQUIRE(power(x, s) == Approx(exact).epsilon(std::max(n, 1) * 0x1p-24).margin(0));
            const double of_root = std::pow(std::sqrt(static_cast<double>(x)), n);
            REQUIRE(power_of_root(x, s) == Approx(of_root).epsilon((n + 2) * 0x1p-25).margin(0));
        }
    }
}

TEST_CASE("fractional exponents and those above 1024 use polynomials that match squaring", "[power]") {
    for (const float s : {0.5f, 2.5f, 31.999998f, 1024.5f, 1025.0f, 10000.0f})
        CHECK(Exponent<float>(s).whole == -1);
    for (int n = 1; n <= 1024; ++n)
        for (const float wanted : {0.9f, 0.5f, 0.01f, 1e-6f}) {
            const auto s = static_cast<float>(n);
            const float x = std::pow(wanted, 1 / s);
            CHECK(power(x, Exponent<float>(s)) == Approx(power(x, s)).epsilon(4e-6 + n * 0x1p-24));
            Exponent<float> smooth(s);
            smooth.whole = -1;
            CHECK(power_of_root(x, Exponent<float>(s)) ==
                  Approx(power_of_root(x, smooth)).epsilon(4e-6 + n * 0x1p-24));
        }
}

TEST_CASE("a whole power of a negative number equals the same power of 0", "[power]") {
    CHECK(power(-0.5f, Exponent<float>(2.0f)) == 0.0f);
    CHECK(power(-0.5f, Exponent<float>(0.0f)) == 1.0f);
}

TEST_CASE("anything to the power 0 is 1, and 0 to any other power is 0", "[power]") {
    CHECK(power(0.0f, 0.0f) == 1.0f);
    CHECK(power(0.3f, 0.0f) == 1.0f);
    CHECK(power(0.0f, 0.5f) == 0.0f);
    CHECK(power(0.0f, 10000.0f) == 0.0f);
    CHECK(power(1e-40f, 2.0f) == 0.0f);
}

TEST_CASE("a power below the smallest float is 0, even for a huge exponent", "[power]") {
    for (const float s : {1e5f, 1e7f, 3e8f, 1e30f}) {
        CHECK(power(0.3f, s) == 0.0f);
        CHECK(power(1.2e-38f, s) == 0.0f);
    }
}

TEST_CASE("the peak of a highlight is exactly 1 at any shininess", "[power]") {
    for (float s = 0; s <= 10000; s += 7) CHECK(power(1.0f, s) == 1.0f);
}

TEMPLATE_TEST_CASE_SIG("SIMD lanes give the same bits as float", "[power][lanes]", ((int N), N), 4, 8, 16) {
    std::mt19937 random(5);
    for (int round = 0; round < 2000; ++round) {
        float x[N], s[N], wide[N];
        for (int i = 0; i < N; ++i) {
            x[i] = static_cast<float>(random() % 1000001) * 1e-6f;
            s[i] = random() % 4 != 0 ? static_cast<float>(random() % 2000) * 0.25f : 0.0f;
        }
        store(wide, power(load<Lanes<N>>(x), load<Lanes<N>>(s)));
        for (int i = 0; i < N; ++i) REQUIRE(bits_of(wide[i]) == bits_of(power(x[i], s[i])));
        const Exponent<Lanes<N>> same_s{Lanes<N>(s[0])};
        store(wide, power_of_root(load<Lanes<N>>(x), same_s));
        if (s[0] > 0)
            for (int i = 0; i < N; ++i)
                REQUIRE(bits_of(wide[i]) == bits_of(power_of_root(x[i], Exponent<float>(s[0]))));
    }
}

// Compares bytes of a picture with IEC 61966-2-1 in double.
namespace {

/// The two pieces of the standard's function, for linear x from 0 to 1.
double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

/// The byte of a background of that much light, which the display converts like any pixel.
int byte_shown(float linear, Transfer transfer, float exposure = 1) {
    Scene scene;
    scene.display.background = glm::vec3(linear);
    scene.display.transfer = transfer;
    scene.display.exposure = exposure;
    Renderer renderer(1);
    return renderer.render(scene, {1, 1}).rgba[0];
}

}  // namespace

TEST_CASE("sRGB is linear up to 0.0031308 and a power above: its bytes match the standard", "[display]") {
    std::vector<float> linear{0, 0.0031308f, 0.0031309f, 0.04045f, 0.5f, 1};
    for (int i = 1; i <= 60; ++i) linear.push_back(0.001f * static_cast<float>(i));
    for (const float x : linear) {
        INFO("linear " << x);
        const double exact = 255 * srgb(double{x});
        const int byte = byte_shown(x, Transfer::Srgb);
        CHECK(std::abs(byte - exact) < 0.501);  // rounded to the nearest
    }
    CHECK(byte_shown(0.02f, Transfer::Srgb) == 39);  // 12.92 x would be 66
}

TEST_CASE("exposure is applied before clipping to the display's range", "[display]") {
    for (const float exposure : {0.0f, 0.25f, 0.5f, 2.0f, 3.0f})
        for (const float x : {0.0f, 0.1f, 0.3f, 0.45f, 0.7f, 1.0f, 1.5f, 3.0f}) {
            CAPTURE(exposure, x);
            const double exact = 255 * std::min(double{x} * exposure, 1.0);
            CHECK(std::abs(byte_shown(x, Transfer::None, exposure) - exact) < 0.501);
        }
    CHECK(byte_shown(3, Transfer::None, 0.25f) == 191);  // 3/4 of 255; clipping first would give 64
}

TEST_CASE("either transfer displays white as 1, and nearly white as less than 1", "[display]") {
    for (const Transfer transfer : {Transfer::None, Transfer::Srgb}) {
        Scene scene;
        scene.display.transfer = transfer;
        scene.display.background = {1, 7, 0.999f};
        Renderer renderer(1);
        (void)renderer.render(scene, {1, 1});
        const Explanation e = renderer.explain(0, 0);
        CHECK(e.displayed.x == 1);
        CHECK(e.displayed.y == 1);
        CHECK(e.displayed.z < 1);
        CHECK(e.byte[0] == 255);
    }
}
