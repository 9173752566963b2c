// The lecture's lighting equation: its terms and their dependencies.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "models/numbers.h"
#include "renderer/lighting/illuminate.h"
#include "tests/support/lecture_scene.h"

using namespace glint;
using namespace glint::test;
using Vec = Vec3<float>;

namespace {

Vec at_angle(double degrees) {
    return {static_cast<float>(std::sin(degrees * degree)), 0,
            static_cast<float>(std::cos(degrees * degree))};
}

LightAt<float> light_at(Vec xyz, float w) {
    LightAt<float> light;
    light.xyz = xyz;
    light.w = w;
    light.ambient = {0.5f, 0.5f, 0.5f};
    light.diffuse = light.specular = {1, 1, 1};
    return light;
}

MaterialAt<float> material(float shininess) {
    MaterialAt<float> m;
    m.k_a = {0.1f, 0.1f, 0.1f};
    m.k_d = {0.5f, 0.5f, 0.5f};
    m.k_s = {0.4f, 0.4f, 0.4f};
    m.shininess = shininess;
    return m;
}

float highlight(Reflection model, Vec l, PointAt<float> at, float shininess) {
    return illuminate(Equation{model, {}}, light_at(l, 0), material(shininess), at).response.specular.x;
}

struct Moved {
    bool ambient, diffuse, specular;
    bool operator==(const Moved&) const = default;
};

Moved moved(const LightTerms<float>& a, const LightTerms<float>& b) {
    return {a.ambient.x != b.ambient.x, a.diffuse.x != b.diffuse.x, a.specular.x != b.specular.x};
}

}  // namespace

TEST_CASE("the plates of the cosine law show the cosine of their tilt from every viewpoint", "[lecture]") {
    Scene scene = lecture_scene("cosine-law");
    for (const glm::vec3 eye : {glm::vec3(0, 4.5f, 4.5f), glm::vec3(0, 2, 6), glm::vec3(1, 6, 3)}) {
        scene.camera.eye = eye;
        const Drawn drawn(scene);
        for (int i = 0; i < 7; ++i) {
            CAPTURE(i);
            CHECK(drawn.colour({-3 + i, 0, 0}).x == Approx(std::cos(15 * i * degree)).margin(1e-6));
        }
    }
}

TEST_CASE("every dot product in an explanation is the same in camera and world coordinates", "[lecture]") {
    const Drawn drawn(lecture_scene("sun-and-headlight"));
    const int seen = drawn.for_each_of(0, 6, [](const Explanation& e) {
        for (const ExplainedLight& light : e.at.lights) {
            CHECK(dot(e.at.normal.world, light.l.world) == Approx(light.n_dot_l).margin(1e-5));
            CHECK(dot(light.r.world, e.at.view.world) == Approx(light.r_dot_v).margin(1e-5));
            CHECK(dot(e.at.normal.world, light.h.world) == Approx(light.n_dot_h).margin(1e-5));
        }
    });
    CHECK(seen > 100);
}

TEST_CASE("the mirror plate shows r = (-2, 23, 14) / 27", "[lecture]") {
    const Explanation e = Drawn(lecture_scene("mirror-vector")).at({0.15, -0.575, 0.5});
    REQUIRE(e.object_index == 0);
    CHECK(e.at.lights[0].n_dot_l == Approx(8.0 / 9).epsilon(1e-5));
    CHECK(e.at.lights[0].r.world.x == Approx(-2.0 / 27).margin(1e-5));
    CHECK(e.at.lights[0].r.world.y == Approx(23.0 / 27).epsilon(1e-5));
    CHECK(e.at.lights[0].r.world.z == Approx(14.0 / 27).epsilon(1e-5));
}

TEST_CASE("the highlights of the grid fall off as (v.r)^n", "[lecture]") {
    const Drawn drawn(lecture_scene("shininess-grid"));
    int lit = 0;
    for (int ball = 0; ball < 24; ++ball)
        drawn.for_each_of(ball, 3, [&](const Explanation& e) {
            const ExplainedLight& light = e.at.lights[0];
            if (light.n_dot_l <= 0 || light.r_dot_v <= 0) return;
            const double exact = std::pow(static_cast<double>(light.r_dot_v), e.material.shininess);
            CHECK(light.specular_factor.x == Approx(exact).epsilon(1e-5).margin(1e-6));
            ++lit;
        });
    CHECK(lit > 500);
}

TEST_CASE("Blinn-Phong is close to Phong's lobe with 4 n, and closer with the best exponent", "[lecture]") {
    const struct {
        float n, best;
        double error_of_4n, error_of_best;
    } rows[] = {{5, 21.3425f, 0.030074, 0.015562},
                {10, 41.2957f, 0.014246, 0.007163},
                {20, 81.2727f, 0.006940, 0.003437},
                {50, 201.2590f, 0.002734, 0.001341},
                {100, 401.2545f, 0.001360, 0.000665}};
    const Vec n{0, 0, 1};
    for (const auto& row : rows) {
        CAPTURE(row.n);
        double error_of_4n = 0, error_of_best = 0;
        for (int step = 0; step <= 1800; ++step) {  // l = n, so r = n, and h is halfway to v
            const PointAt<float> at{{}, n, at_angle(0.05 * step)};
            const double phong = highlight(Reflection::Phong, n, at, row.n);
            error_of_4n =
                std::max(error_of_4n, std::abs(phong - highlight(Reflection::BlinnPhong, n, at, 4 * row.n)));
            error_of_best =
                std::max(error_of_best, std::abs(phong - highlight(Reflection::BlinnPhong, n, at, row.best)));
        }
        CHECK(error_of_4n == Approx(row.error_of_4n).margin(2e-5));
        CHECK(error_of_best == Approx(row.error_of_best).margin(2e-5));
    }
}

TEST_CASE("plates at 60, 25 and 0 degrees have the slide's intensities", "[lecture]") {
    // rho = (.1, .5, .4), n = 20. In the scene, v is n; in the equation below, v is r.
    const Drawn drawn(lecture_scene("three-angles"));
    CHECK(drawn.colour({-2, 0, 0}).x == Approx(0.35).margin(2e-3));  // not exactly at the plate's centre
    CHECK(drawn.colour({0, 0, 0}).x == Approx(0.609075).margin(2e-3));
    CHECK(drawn.colour({2, 0, 0}).x == Approx(1).margin(2e-3));
    for (const auto& [angle, total] : {std::pair{60.0, 0.75}, {25.0, 0.953154}, {0.0, 1.0}}) {
        const PointAt<float> at{{}, {0, 0, 1}, at_angle(-angle)};
        const auto t = illuminate(Equation{}, light_at(at_angle(angle), 0), material(20), at);
        CHECK(0.1 + t.diffuse.x + t.specular.x == Approx(total).epsilon(1e-5));
    }
}

TEST_CASE("normal, light and viewer change exactly the terms that the review names", "[lecture]") {
    const PointAt<float> at{{}, {0, 0, 1}, at_angle(-20)};
    const PointAt<float> turned{{}, at_angle(5), at.v}, seen_elsewhere{{}, at.n, at_angle(-30)};
    const auto lit = [](const LightAt<float>& light, const PointAt<float>& p) {
        return illuminate(Equation{}, light, material(8), p);
    };
    for (const float w : {0.0f, 1.0f}) {
        const LightAt<float> light = light_at(at_angle(30), w), elsewhere = light_at(at_angle(40), w);
        CHECK(moved(lit(light, at), lit(light, turned)) == Moved{false, true, true});
        CHECK(moved(lit(light, at), lit(elsewhere, at)) == Moved{false, true, true});
        CHECK(moved(lit(light, at), lit(light, seen_elsewhere)) == Moved{false, false, true});
    }
}

TEST_CASE("the position of a point matters for a bulb but not for a sun", "[lecture]") {
    // If the point moves sideways, with the same normal and viewing direction, only a bulb's direction
    // changes. A sun does not change if its direction vector is made longer.
    const PointAt<float> here{{}, {0, 0, 1}, at_angle(-20)}, there{{0.3f, 0, 0}, here.n, here.v};
    const auto lit = [](Vec xyz, float w, const PointAt<float>& p) {
        return illuminate(Equation{}, light_at(xyz, w), material(8), p);
    };
    const Vec l = at_angle(30);
    CHECK(moved(lit(l, 0, here), lit(l, 0, there)) == Moved{false, false, false});
    CHECK(moved(lit(l, 0, here), lit(unit(4.0f * l), 0, here)) == Moved{false, false, false});
    CHECK(moved(lit(l, 1, here), lit(l, 1, there)) == Moved{false, true, true});
}

TEST_CASE("a table of cos^n is wrong by half its step times the slope, and shows bands", "[lecture]") {
    const float n = 20;
    for (const int entries : {17, 65, 257, 1025}) {
        CAPTURE(entries);
        std::vector<double> table;
        for (int i = 0; i < entries; ++i) table.push_back(std::pow(double(i) / (entries - 1), n));
        const Mistakes none;
        Equation equation{Reflection::Phong, {}, &none, entries};
        double worst = 0;
        for (double angle = 0; angle < 90; angle += 0.01) {
            const double cosine = std::cos(angle * degree);
            const PointAt<float> at{{0, 0, 0}, {0, 0, 1}, at_angle(angle)};  // the light is along the normal
            const double looked_up =
                illuminate(equation, light_at({0, 0, 1}, 0), material(n), at).response.specular.x;
            const double index = cosine * (entries - 1);
            if (std::abs(index - std::floor(index) - 0.5) > 1e-3)  // rounding decides between two entries
                CHECK(looked_up == Approx(table[static_cast<std::size_t>(std::lround(index))]).margin(1e-5));
            worst = std::max(worst, std::abs(looked_up - std::pow(cosine, n)));
        }
        const double step = 1.0 / (entries - 1);
        CHECK(worst == Approx(1 - std::pow(1 - step / 2, n)).epsilon(0.02));  // the slope is largest at 1
    }
    std::set<float> banded, smooth;
    const auto collect = [](std::set<float>& values, const Assignment& table) {
        Drawn(lecture_scene("glossy-ball", {table})).for_each_of(0, 2, [&](const Explanation& e) {
            values.insert(e.at.lights[0].specular_factor.x);
        });
    };
    collect(banded, {"/shading/power_table", "32"});
    collect(smooth, {"/shading/power_table", "0"});
    CHECK(banded.size() <= 32);
    CHECK(smooth.size() > 200);
}

TEST_CASE("where n.l = 0 a highlight is cut off: 0.330 of Blinn-Phong's, 0.010 of Phong's", "[lecture]") {
    // Light and viewer 150 degrees apart, n = 32: n.h = cos 15 degrees, v.r = cos 30 degrees.
    const PointAt<float> at{{}, {0, 0, 1}, at_angle(-60)};
    CHECK(highlight(Reflection::BlinnPhong, at_angle(89.999), at, 32) == Approx(0.330).margin(1e-3));
    CHECK(highlight(Reflection::Phong, at_angle(89.999), at, 32) == Approx(0.010).margin(1e-3));
    CHECK(highlight(Reflection::BlinnPhong, at_angle(90.001), at, 32) == 0);
    CHECK(highlight(Reflection::Phong, at_angle(90.001), at, 32) == 0);
}

// The lecture's shading modes: the lit points, and the interpolation between them.
namespace {

constexpr PictureSize small{160, 90};

Picture drawn_as(Scene scene, ShadingMode mode, Reflection reflection) {
    scene.shading.mode = mode;
    scene.shading.reflection = reflection;
    Renderer renderer(1);
    return renderer.render(scene, small, true);
}

float brightest(const Picture& picture) {
    return *std::max_element(picture.linear.begin(), picture.linear.end());
}

constexpr ShadingMode modes[] = {ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud,
                                 ShadingMode::Phong};

}  // namespace

TEST_CASE("on a coarse ball every shading and lighting model pair gives a different picture", "[lecture]") {
    const Scene scene = lecture_scene("coarse-ball");
    std::set<std::string> pictures;
    for (const ShadingMode mode : modes)
        for (const Reflection r : {Reflection::Lambert, Reflection::Phong, Reflection::BlinnPhong,
                                   Reflection::Retro, Reflection::OrenNayar, Reflection::CookTorrance}) {
            const std::vector<std::uint8_t> bytes = drawn_as(scene, mode, r).rgba;
            pictures.emplace(bytes.begin(), bytes.end());
        }
    CHECK(pictures.size() == 24);
}

TEST_CASE("flat shading lights a face at its centroid, which is inaccurate under a bulb", "[lecture]") {
    const std::vector<Assignment> lambert{{"/shading/reflection", "lambert"}};
    Scene scene = lecture_scene("bulb-over-facets", lambert);
    const glm::dvec3 to_light =
        glm::dvec3(0.75, 1.35, 1.45) - glm::dvec3(0, 0, 0.9);  // from the centre of the front face
    const double r = length(to_light), falloff = 1 / (0.5 + 0.3 * r * r);
    const double expected = 0.62 * 0.09 + 0.62 * 0.95 * falloff * 0.55 / r;
    scene.shading.mode = ShadingMode::Flat;
    const Drawn flat(scene);
    scene.shading.mode = ShadingMode::Facet;
    const Drawn facet(scene);
    double least = 1, most = 0;
    const int seen = flat.for_each_of(0, 2, [&](const Explanation& e) {
        if (e.at.normal.world.z < 0.99f) return;
        CHECK(e.sum.x == Approx(expected).epsilon(1e-5));
        const double right = facet.picture().linear_at(e.x, e.y).x;
        least = std::min(least, right);
        most = std::max(most, right);
    });
    CHECK(seen > 100);
    CHECK(most > 2 * expected);
    CHECK(least < 0.7 * expected);
}

TEST_CASE("facet shading lights each pixel with the normal of its facet", "[lecture]") {
    const Drawn drawn(lecture_scene("bulb-over-facets"));
    const int seen = drawn.for_each_of(0, 3, [](const Explanation& e) {
        const glm::vec3 n = e.at.normal.world;
        CHECK(std::max({n.x, n.y, n.z}) == Approx(1).margin(1e-6));
        CHECK(std::abs(n.x) + std::abs(n.y) + std::abs(n.z) == Approx(1).margin(1e-6));
        const glm::dvec3 to_light = glm::dvec3(0.75, 1.35, 1.45) - glm::dvec3(e.at.point.world);
        const double cosine = std::max(dot(glm::dvec3(n), normalize(to_light)), 0.0);
        const double d = length(to_light);
        CHECK(e.at.lights[0].diffuse.x == Approx(0.62 * 0.95 * cosine / (0.5 + 0.3 * d * d)).margin(1e-5));
    });
    CHECK(seen > 500);
}

TEST_CASE("Gouraud shading loses a lamp's light inside a quad, Phong shading shows it", "[lecture]") {
    Scene scene = lecture_scene("lost-highlight");
    const glm::dvec3 under_the_lamp{-1.45, 0, -0.1};
    const glm::vec3 gouraud = Drawn(scene).colour(under_the_lamp);
    scene.shading.mode = ShadingMode::Phong;
    const glm::vec3 phong = Drawn(scene).colour(under_the_lamp);
    scene.lights.clear();
    CHECK(gouraud == Drawn(scene).colour(under_the_lamp));
    CHECK(phong.x > gouraud.x + 0.3f);
}

TEST_CASE("Phong shading and Phong lighting are independent of each other", "[lecture]") {
    const Scene scene = lecture_scene("glossy-ball");
    const float matt = brightest(drawn_as(scene, ShadingMode::Phong, Reflection::Lambert));
    const float glossy = brightest(drawn_as(scene, ShadingMode::Phong, Reflection::Phong));
    const float gouraud = brightest(drawn_as(scene, ShadingMode::Gouraud, Reflection::Phong));
    CHECK(matt < 0.5f);            // k_a 0.1 + k_d 0.8 n.l, at most 0.55 (0.1 + 0.8)
    CHECK(glossy > matt + 0.4f);   // k_s 0.7 times 0.8
    CHECK(gouraud > matt + 0.4f);  // a fine mesh has a vertex near the peak
}

TEST_CASE("every shading mode covers the same pixels: the silhouette stays a polygon", "[lecture]") {
    Scene scene = lecture_scene("coarse-silhouette");
    std::set<std::vector<bool>> masks;
    for (const ShadingMode mode : modes) {
        scene.shading.mode = mode;
        const Drawn drawn(scene, small);
        std::vector<bool> mask;
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) mask.push_back(drawn.renderer().object_at(x, y) >= 0);
        masks.insert(mask);
    }
    CHECK(masks.size() == 1);
}

TEST_CASE("a facet has one colour only under a sun and without highlights", "[lecture]") {
    Scene scene = lecture_scene("one-colour-facets");
    const auto spread = [&scene] {
        std::map<std::uint32_t, std::pair<float, float>> range;
        Drawn(scene).for_each_of(0, 2, [&range](const Explanation& e) {
            const auto [at, first] = range.try_emplace(e.face, e.sum.x, e.sum.x);
            at->second = {std::min(at->second.first, e.sum.x), std::max(at->second.second, e.sum.x)};
        });
        float widest = 0;
        for (const auto& [face, r] : range) widest = std::max(widest, r.second - r.first);
        return widest;
    };
    CHECK(spread() < 1e-6f);
    scene.shading.reflection = Reflection::Phong;
    CHECK(spread() > 0.02f);
    scene.shading.reflection = Reflection::Lambert;
    scene.lights[0].kind = LightKind::Point;
    scene.lights[0].position.w = 1;
    CHECK(spread() > 0.02f);
}
