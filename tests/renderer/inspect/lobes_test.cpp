// Compares lobes of every reflection model with closed forms and published tables: energy, albedo,
// reciprocity, direction.
#include "renderer/reflectance/lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "models/numbers.h"
#include "renderer/reflectance/microfacets.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

constexpr double pi = std::numbers::pi;

/// Only the specular term, of strength 1.
Reflector mirror_like(Reflection reflection, float shininess = 32, float roughness = 0.5f) {
    Reflector r;
    r.reflection = reflection;
    r.material.diffuse = glm::vec3(0);
    r.material.specular = r.material.f0 = glm::vec3(1);
    r.material.shininess = shininess;
    r.material.roughness = roughness;
    return r;
}

/// Only the diffuse term, of strength 1.
Reflector matt(Reflection reflection, float sigma_deg = 0) {
    Reflector r = mirror_like(reflection, 32, sigma_deg / 90);
    r.material.diffuse = glm::vec3(1);
    r.material.specular = glm::vec3(0);
    return r;
}

/// A direction at this angle from n, perpendicular to the plane of incidence.
glm::vec3 out_of_plane(double deg) { return {0, std::sin(deg * degree), std::cos(deg * degree)}; }

/// The direction of the largest specular term in the plane of incidence, in degrees from n.
double brightest(const Reflector& r, double light_deg) {
    const auto slice = lobe_slice(r, light_deg, 1800);
    return std::max_element(slice.begin(), slice.end(),
                            [](const LobeSample& a, const LobeSample& b) {
                                return a.reflected.specular.x < b.reflected.specular.x;
                            })
        ->view_deg;
}

}  // namespace

TEST_CASE("lobe: a slice equals the closed form at every angle", "[lobes]") {
    const auto slice = lobe_slice(mirror_like(Reflection::Phong, 20), 25, 180);
    REQUIRE(slice.size() == 181);
    CHECK(slice.front().view_deg == -90);
    CHECK(slice.back().view_deg == 90);
    for (const LobeSample& s : slice) {
        const double lobe = std::pow(std::max(std::cos((s.view_deg - 25) * degree), 0.0), 20);
        CHECK(s.reflected.specular.x == Approx(lobe).margin(1e-5));
    }
}

TEST_CASE("lobe: Phong and Blinn-Phong peak at the mirror direction, retro at the light", "[lobes]") {
    CHECK(brightest(mirror_like(Reflection::Phong), 40) == Approx(40));
    CHECK(brightest(mirror_like(Reflection::BlinnPhong), 40) == Approx(40));
    CHECK(brightest(mirror_like(Reflection::Retro), 40) == Approx(-40));
    // Rough microfacets peak beyond it: the off-specular peak of Torrance and Sparrow.
    CHECK(brightest(mirror_like(Reflection::CookTorrance, 32, 0.3f), 40) == Approx(40).margin(1));
    CHECK(brightest(mirror_like(Reflection::CookTorrance, 32, 0.7f), 40) > 45);
}

TEST_CASE("lobe: the energy of Phong's lobe is 2 pi / (shininess + 2)", "[lobes]") {
    for (const float s : {0.0f, 1.0f, 10.0f, 32.0f, 100.0f, 1000.0f, 10000.0f}) {
        INFO("shininess " << s);
        const double closed = 2 * pi / (static_cast<double>(s) + 2);
        CHECK(specular_energy(mirror_like(Reflection::Phong, s), 0).x == Approx(closed).epsilon(1e-4));
        CHECK(specular_energy(mirror_like(Reflection::Retro, s), 0).x == Approx(closed).epsilon(1e-4));
    }
    // While the lobe is above the horizon, it is scaled by the cosine of its direction.
    CHECK(specular_energy(mirror_like(Reflection::Phong, 100), 60).x == Approx(pi / 102).epsilon(1e-4));
}

TEST_CASE("lobe: the energy of Blinn-Phong's lobe matches Giesen's closed form", "[lobes]") {
    for (const double s : {1.0, 10.0, 32.0, 100.0}) {
        INFO("shininess " << s);
        const double closed = 8 * pi * (std::pow(2, -s / 2) + s) / ((s + 2) * (s + 4));
        const Reflector r = mirror_like(Reflection::BlinnPhong, static_cast<float>(s));
        CHECK(specular_energy(r, 0).x == Approx(closed).epsilon(1e-4));
    }
    const Reflector r = mirror_like(Reflection::BlinnPhong, 100);
    CHECK(specular_energy(r, 60).x / specular_energy(r, 0).x == Approx(0.265058).epsilon(2e-3));
}

TEST_CASE("lobe: white Lambert reflects all light, from every direction", "[lobes][energy]") {
    for (const double deg : {0.0, 30.0, 60.0, 89.0})
        CHECK(directional_albedo(matt(Reflection::Lambert), deg).x == Approx(1).epsilon(1e-4));
}

TEST_CASE("lobe: Oren-Nayar's albedo matches the table", "[lobes][energy]") {
    const double table[][3] = {{0, 0.8652, 0.7019}, {60, 0.9423, 0.8151}, {80, 0.9786, 0.8683}};
    for (const auto& [deg, at_20, at_40] : table) {
        INFO("light at " << deg);
        CHECK(directional_albedo(matt(Reflection::OrenNayar, 20), deg).x == Approx(at_20).margin(2e-4));
        CHECK(directional_albedo(matt(Reflection::OrenNayar, 40), deg).x == Approx(at_40).margin(2e-4));
    }
}

TEST_CASE("lobe: Cook-Torrance's albedo matches the table, and never exceeds 1", "[lobes][energy]") {
    const double table[][5] = {{0, 0.9883, 0.9158, 0.6879, 0.3069},
                               {60, 0.9692, 0.8573, 0.6983, 0.4507},
                               {80, 0.8955, 0.8556, 0.8053, 0.6682}};
    const double a[] = {0.1, 0.25, 0.5, 1};
    for (const auto& row : table)
        for (std::size_t i = 0; i < 4; ++i) {
            INFO("light at " << row[0] << ", a = " << a[i]);
            const auto roughness = static_cast<float>(std::sqrt(a[i]));
            const double albedo =
                directional_albedo(mirror_like(Reflection::CookTorrance, 0, roughness), row[0]).x;
            CHECK(albedo == Approx(row[i + 1]).margin(5e-4));
            CHECK(albedo <= 1);
        }
}

TEST_CASE("lobe: the albedo at grazing incidence matches an independent integral", "[lobes][energy]") {
    // From a separate program: 4000 x 4000 directions v, dense at the horizon and at the plane of incidence.
    const double cook_torrance[][4] = {{88, 0.979876, 0.893369, 0.949353},
                                       {89, 0.937209, 0.924960, 0.971168},
                                       {89.5, 0.894263, 0.957117, 0.983951}};
    const float roughness[] = {0.08f, 0.2f, 0.5f};
    for (const auto& row : cook_torrance)
        for (std::size_t i = 0; i < 3; ++i) {
            INFO("light at " << row[0] << ", roughness " << roughness[i]);
            const Reflector r = mirror_like(Reflection::CookTorrance, 0, roughness[i]);
            CHECK(directional_albedo(r, row[0]).x == Approx(row[i + 1]).margin(1e-4));
        }
    const double blinn_phong[][3] = {{80, 0.011715342, 7.6226244e-05},
                                     {89, 0.0028992136, 1.2636533e-06},
                                     {89.9, 0.002418946, 3.0757831e-07}};
    for (const auto& [deg, at_100, at_10000] : blinn_phong) {
        INFO("light at " << deg);
        CHECK(specular_energy(mirror_like(Reflection::BlinnPhong, 100), deg).x ==
              Approx(at_100).epsilon(5e-4));
        CHECK(specular_energy(mirror_like(Reflection::BlinnPhong, 10000), deg).x ==
              Approx(at_10000).epsilon(5e-4));
    }
    // The smoothest surface: a mirror except for Smith's 2 / (1 + sqrt(1 + a^2 tan^2)) each way, a = 0.001 at
    // 60 degrees.
    CHECK(directional_albedo(mirror_like(Reflection::CookTorrance, 0, 0), 60).x == Approx(1).margin(1e-5));
}

TEST_CASE("lobe: BRDFs are reciprocal, the slides' Phong as f / n.l is not", "[lobes][reciprocity]") {
    CHECK(reciprocity_error(matt(Reflection::Lambert)) < 1e-5);
    CHECK(reciprocity_error(matt(Reflection::OrenNayar, 30)) < 1e-4);
    CHECK(reciprocity_error(mirror_like(Reflection::CookTorrance)) < 1e-4);
    CHECK(reciprocity_error(mirror_like(Reflection::Phong)) > 0.5);
    CHECK(reciprocity_error(mirror_like(Reflection::BlinnPhong)) > 0.5);
    CHECK(reciprocity_error(mirror_like(Reflection::Retro)) > 0.5);
}

TEST_CASE("lobe: f of Cook-Torrance and Oren-Nayar matches hand-computed values", "[lobes]") {
    Reflector ggx = mirror_like(Reflection::CookTorrance, 0, 0.5f);  // a = .25
    ggx.material.f0 = glm::vec3(0.04f);
    CHECK(brdf(ggx, in_plane(-30), in_plane(30)).x == Approx(0.06727924).epsilon(1e-4));
    CHECK(brdf(ggx, in_plane(-45), in_plane(0)).x == Approx(0.00694186).epsilon(1e-4));
    CHECK(brdf(ggx, in_plane(-60), in_plane(60)).x == Approx(0.32715333).epsilon(1e-4));
    CHECK(brdf(ggx, in_plane(-60), in_plane(-60)).x == Approx(0.00124578).epsilon(1e-4));
    CHECK(brdf(ggx, in_plane(-70), out_of_plane(20)).x == Approx(0.00322489).epsilon(1e-4));
    const Reflector at_20 = matt(Reflection::OrenNayar, 20), at_40 = matt(Reflection::OrenNayar, 40);
    CHECK(brdf(at_20, in_plane(-30), in_plane(30)).x == Approx(0.2753915).epsilon(1e-5));
    CHECK(brdf(at_20, in_plane(-60), in_plane(-60)).x == Approx(0.3989710).epsilon(1e-5));
    CHECK(brdf(at_20, in_plane(-70), out_of_plane(20)).x == Approx(0.2753915).epsilon(1e-5));
    CHECK(brdf(at_40, in_plane(-45), in_plane(0)).x == Approx(0.2234098).epsilon(1e-5));
    CHECK(brdf(at_40, in_plane(-60), in_plane(-60)).x == Approx(0.4047779).epsilon(1e-5));
    CHECK(brdf(matt(Reflection::OrenNayar), in_plane(-50), out_of_plane(20)).x == Approx(1 / pi));
    CHECK(brdf(ggx, in_plane(-95), in_plane(0)) == glm::vec3(0));  // light from below the surface gives 0
}

TEST_CASE("lobe: the CSV has a column for each channel of each term", "[lobes]") {
    const std::string csv = lobe_csv(lobe_slice(matt(Reflection::Lambert), 0, 2));
    CHECK(csv.starts_with(
        "view_deg,ambient_r,ambient_g,ambient_b,diffuse_r,diffuse_g,diffuse_b,specular_r,specular_g,"
        "specular_b,intensity_r,intensity_g,intensity_b,brdf_r,brdf_g,brdf_b\n-90,"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
}

// Rough surfaces modelled as many small mirrors: counts of rays against the densities of normals.
namespace {

MicrofacetOptions many(double sigma_deg, double light_deg) {
    MicrofacetOptions o;
    o.roughness = sigma_deg / 90;
    o.light_deg = o.view_deg = light_deg;
    o.facets = 40000;
    o.rays = 100000;
    return o;
}

}  // namespace

TEST_CASE("microfacets: at 20 degrees of tilt 2.4 % of head-on rays go into the surface", "[microfacets]") {
    // A facet tilted by more than 45 degrees reflects a head-on ray below the horizon: 2.25 standard
    // deviations, 2.44 %.
    const MicrofacetPicture p = microfacet_picture(many(20, 0));
    CHECK(p.inward == Approx(0.0244).margin(0.002));
    CHECK(p.shadowed == 0);  // nothing blocks a head-on ray
}

TEST_CASE("microfacets: every ray leaves its facet at the angle of incidence", "[microfacets]") {
    const MicrofacetPicture p = microfacet_picture(many(15, 35));
    REQUIRE(p.rays.size() == 100000);
    for (const FacetRay& ray : p.rays) {
        const double tilt = p.tilt_deg[static_cast<std::size_t>(ray.facet)];
        REQUIRE(std::abs(std::remainder((ray.out_deg - tilt) - (tilt + 35), 360)) < 1e-9);
        REQUIRE(std::abs(tilt + 35) <= 90 + 1e-9);  // the facet faces the light
    }
    CHECK(p.free + p.shadowed + p.masked + p.inward == Approx(1));
    CHECK(std::accumulate(p.histogram.begin(), p.histogram.end(), 0.0) == Approx(p.free));
}

TEST_CASE("microfacets: a smooth surface is one mirror", "[microfacets]") {
    const MicrofacetPicture p = microfacet_picture(many(0, 32));
    CHECK(p.free == Approx(1));
    CHECK(p.histogram[(90 + 32) / 5] == Approx(1));
    CHECK(p.shining_share == 1);
    CHECK(p.shining_expected == 1);
    CHECK(p.smith_g1 == 1);
}

TEST_CASE("microfacets: the number of facets with normal h follows the density of tilts", "[microfacets]") {
    for (const double view : {30.0, 10.0, -20.0, 60.0}) {
        MicrofacetOptions o = many(15, 30);
        o.rays = 1;
        o.view_deg = view;
        const MicrofacetPicture p = microfacet_picture(o);
        INFO("view " << view);
        CHECK(p.h_deg == (view - 30) / 2);
        // The normal distribution's integral over h +- 2.5 degrees, by its error function.
        const auto below = [](double deg) { return 0.5 * std::erf(deg / (15 * std::sqrt(2))); };
        CHECK(p.shining_expected == Approx(below(p.h_deg + 2.5) - below(p.h_deg - 2.5)).epsilon(1e-3));
        CHECK(p.shining_share == Approx(p.shining_expected).margin(0.01));
    }
}

TEST_CASE("microfacets: the fraction of unshadowed rays follows Smith's G1", "[microfacets]") {
    for (const double sigma : {10.0, 20.0, 30.0}) {
        double before = 1;
        for (const double light : {30.0, 50.0, 60.0, 70.0, 80.0}) {
            const MicrofacetPicture p = microfacet_picture(many(sigma, light));
            INFO("sigma " << sigma << ", light " << light << ": counted " << 1 - p.shadowed << ", Smith "
                          << p.smith_g1);
            CHECK(1 - p.shadowed == Approx(p.smith_g1).margin(0.08));
            CHECK(p.smith_g1 < before);
            before = p.smith_g1;
        }
    }
}

TEST_CASE("microfacets: equal seeds give equal pictures, different seeds do not", "[microfacets]") {
    MicrofacetOptions o;
    const MicrofacetPicture a = microfacet_picture(o), b = microfacet_picture(o);
    CHECK(a.profile == b.profile);
    CHECK(a.free == b.free);
    o.seed = 2;
    CHECK(microfacet_picture(o).profile != a.profile);
}

TEST_CASE("microfacets: bounced rays in space converge to D(h) (n.h) / (4 v.h)", "[microfacets]") {
    for (const double roughness : {0.0, 0.05, 0.1, 0.3, 0.5, 0.8}) {
        for (const double view : {0.0, 32.0, 70.0, 89.0}) {
            INFO("roughness " << roughness << ", view " << view);
            double counted = 0, expected = 0;
            for (const LobeBin& bin : facet_lobe(roughness, view, 200000, 3)) {
                INFO("bin from " << bin.from_deg << ": " << bin.share << " against " << bin.expected);
                // Four standard deviations of a counted fraction, plus the quadrature error.
                CHECK(std::abs(bin.share - bin.expected) < 4 * std::sqrt(bin.expected / 200000) + 1e-4);
                counted += bin.share;
                expected += bin.expected;
            }
            CHECK(counted > 0.4);
            CHECK(counted <= 1 + 1e-9);
            CHECK(expected == Approx(counted).margin(0.006));
        }
    }
}

TEST_CASE("microfacets: head-on, half the GGX facets are tilted by less than atan(a)", "[microfacets]") {
    // The density's closed integral: tan^2 = a^2 u / (1 - u) is a^2 at u = 1/2.
    std::mt19937 random(5);
    int less = 0;
    for (int i = 0; i < 100000; ++i) less += sampled_normal(0.5, random).z > std::cos(std::atan(0.25));
    CHECK(less / 1e5 == Approx(0.5).margin(0.01));
}

TEST_CASE("microfacets: there are no rays if no facet faces the light", "[microfacets]") {
    MicrofacetOptions o;
    o.roughness = 1;
    o.light_deg = 89;
    o.facets = 4;
    std::size_t dark = 0;
    for (o.seed = 1; o.seed <= 100; ++o.seed) {
        const MicrofacetPicture p = microfacet_picture(o);
        dark += p.rays.empty() ? 1 : 0;
        CHECK(p.free + p.shadowed + p.masked + p.inward == Approx(p.rays.empty() ? 0 : 1));
        for (const FacetRay& ray : p.rays) CHECK(std::isfinite(ray.at.x));
    }
    // Rays aim at two facets, and about half of all facets lean away by more than one degree.
    CHECK(dark > 10);
    CHECK(dark < 40);
}
