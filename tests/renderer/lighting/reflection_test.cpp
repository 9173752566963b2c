// The extension models against tabulated values, and every model against physics: reciprocity, energy. As a
// BRDF, radiance = f <n.l> E, a model's factor here is f pi <n.l> (the equation's Lambert term has no 1/pi).
#include "renderer/lighting/reflection.h"

#include <cmath>
#include <numbers>

#include "tests/support/catch.h"

using namespace glint;
using Vec = Vec3<float>;

namespace {

constexpr double pi = std::numbers::pi;

Vec direction(double theta_deg, double phi_deg) {
    const double t = theta_deg * pi / 180, p = phi_deg * pi / 180;
    return {static_cast<float>(std::sin(t) * std::cos(p)), static_cast<float>(std::sin(t) * std::sin(p)),
            static_cast<float>(std::cos(t))};
}

struct Bench {
    Reflection model = Reflection::OrenNayar;
    MaterialAt<float> m;
    /// Diffuse and specular factors for l and v around n = z.
    [[nodiscard]] Response<float> at(Vec l, Vec v) const {
        const PointAt<float> point{{}, {0, 0, 1}, v};
        return respond(model, directions_for(l, point), m, point);
    }
    /// f by its formula: of the diffuse and the specular part together, rho = 1.
    [[nodiscard]] double brdf(Vec l, Vec v) const {
        const Response<float> r = at(l, v);
        return (static_cast<double>(r.diffuse) * (model == Reflection::OrenNayar) + r.specular.x) /
               (pi * l.z);
    }
};

}  // namespace

TEST_CASE("Oren-Nayar gives the tabulated values", "[reflection]") {
    Bench b;
    b.m.roughness = 20.0f / 90;  // a standard deviation of 20 degrees
    CHECK(b.brdf(direction(30, 0), direction(30, 180)) == Approx(0.2753915).epsilon(1e-5));
    CHECK(b.brdf(direction(60, 0), direction(60, 0)) == Approx(0.3989710).epsilon(1e-5));
    CHECK(b.brdf(direction(70, 0), direction(20, 90)) == Approx(0.2753915).epsilon(1e-5));
    b.m.roughness = 40.0f / 90;
    CHECK(b.brdf(direction(45, 0), direction(0, 0)) == Approx(0.2234098).epsilon(1e-5));
    CHECK(b.brdf(direction(60, 0), direction(60, 0)) == Approx(0.4047779).epsilon(1e-5));
    b.m.roughness = 0;  // equals Lambert
    CHECK(b.brdf(direction(50, 0), direction(20, 70)) == Approx(1 / pi).epsilon(1e-6));
}

TEST_CASE("Cook-Torrance with GGX gives the tabulated values", "[reflection]") {
    Bench b;
    b.model = Reflection::CookTorrance;
    b.m.roughness = 0.5f;  // a = 0.25
    b.m.f0 = {0.04f, 0.04f, 0.04f};
    CHECK(b.brdf(direction(30, 0), direction(30, 180)) == Approx(0.06727924).epsilon(2e-5));
    CHECK(b.brdf(direction(45, 0), direction(0, 0)) == Approx(0.00694186).epsilon(2e-5));
    CHECK(b.brdf(direction(60, 0), direction(60, 180)) == Approx(0.32715333).epsilon(2e-5));
    CHECK(b.brdf(direction(60, 0), direction(60, 0)) == Approx(0.00124578).epsilon(2e-5));
    CHECK(b.brdf(direction(70, 0), direction(20, 90)) == Approx(0.00322489).epsilon(2e-5));
}

TEST_CASE("Oren-Nayar and Cook-Torrance are reciprocal", "[reflection][property]") {
    for (const Reflection model : {Reflection::OrenNayar, Reflection::CookTorrance}) {
        Bench b;
        b.model = model;
        b.m.roughness = 0.4f;
        b.m.f0 = {0.04f, 0.04f, 0.04f};
        for (int l = 5; l < 90; l += 12)
            for (int v = 5; v < 90; v += 12)
                for (int phi = 0; phi <= 180; phi += 45) {
                    const Vec a = direction(l, 0), c = direction(v, phi);
                    CHECK(b.brdf(a, c) == Approx(b.brdf(c, a)).epsilon(1e-4).margin(1e-7));
                }
    }
}

namespace {

/// The fraction of the light from (theta, 0) that leaves into the hemisphere, by midpoint quadrature.
double albedo(const Bench& b, double theta_deg) {
    const Vec v = direction(theta_deg, 0);  // reciprocal models: swap l and v
    const int steps = 400;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double theta = (i + 0.5) / steps * 90, phi = (j + 0.5) / steps * 360;
            const double t = theta * pi / 180;
            sum += b.brdf(direction(theta, phi), v) * std::cos(t) * std::sin(t);
        }
    return sum * (pi / 2 / steps) * (2 * pi / steps);
}

}  // namespace

TEST_CASE("a white furnace shows the tabulated albedos, none above 1", "[reflection][energy]") {
    Bench ggx;
    ggx.model = Reflection::CookTorrance;
    ggx.m.f0 = {1, 1, 1};
    ggx.m.roughness = std::sqrt(0.5f);  // a = 0.5
    CHECK(albedo(ggx, 0) == Approx(0.6879).epsilon(2e-3));
    CHECK(albedo(ggx, 60) == Approx(0.6983).epsilon(2e-3));
    ggx.m.roughness = 1;
    CHECK(albedo(ggx, 80) == Approx(0.6682).epsilon(2e-3));
    Bench oren;
    oren.m.roughness = 40.0f / 90;
    CHECK(albedo(oren, 0) == Approx(0.7019).epsilon(2e-3));
    CHECK(albedo(oren, 80) == Approx(0.8683).epsilon(2e-3));
}

TEST_CASE("retro-reflection peaks with the viewer at the light", "[reflection]") {
    Bench b;
    b.model = Reflection::Retro;
    b.m.shininess = 32;
    const Vec l = direction(40, 30);
    CHECK(b.at(l, l).specular.x == Approx(1).epsilon(1e-5));
    for (int theta = 0; theta < 90; theta += 10)
        for (int phi = 0; phi < 360; phi += 20) CHECK(b.at(l, direction(theta, phi)).specular.x <= 1.0f);
    CHECK(b.at(l, direction(40, 210)).specular.x < 0.01f);  // nothing in the mirror direction
}
