// Rough surfaces as many mirrors: counted rays against the densities.
#include "renderer/reflectance/microfacets.h"

#include <cmath>
#include <numeric>

#include "renderer/reflectance/lobes.h"
#include "tests/support/catch.h"

using namespace glint;

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
        REQUIRE(std::abs(tilt + 35) <= 90 + 1e-9);  // it faces the light
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

TEST_CASE("microfacets: equal seeds give equal pictures, a different seed a different one", "[microfacets]") {
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
