// The lecture's shading modes: the lit points, and the interpolation between them.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "tests/support/lecture_scene.h"

using namespace glint;
using namespace glint::test;

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

TEST_CASE("flat shading lights a face at its centroid, which is wrong under a bulb", "[lecture]") {
    const std::vector<Assignment> lambert{{"/shading/reflection", "lambert"}};
    Scene scene = lecture_scene("bulb-over-facets", lambert);
    const glm::dvec3 to_light =
        glm::dvec3(0.75, 1.35, 1.45) - glm::dvec3(0, 0, 0.9);  // from the front's centre
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

TEST_CASE("Gouraud shading loses a lamp's light inside a quad; Phong shading shows it", "[lecture]") {
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
