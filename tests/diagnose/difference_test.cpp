// What a diagnosis reports about a difference: its numbers agree with each other and with the picture's own
// bytes.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "diagnose/diagnose.h"
#include "diagnose/diagnosis_format.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

std::uint64_t wrong_in_regions(const Diagnosis& d) {
    std::uint64_t pixels = 0;
    for (const DifferenceRegion& region : d.regions) pixels += region.pixels;
    return pixels;
}

}  // namespace

TEST_CASE("a mistake is named in a picture that is less clipped than the scene's", "[diagnose][release]") {
    SceneDocument document = shipped("default.json");
    for (const char* const name : {"view_reversed", "absolute_cosine", "unnormalized_half"}) {
        const std::size_t mistake = place_of(name);
        document.scene.display.exposure = 1;
        Renderer renderer(1);
        const Picture wrong = renderer.render(under_mistakes(document.scene, {mistake}), {321, 180});
        document.scene.display.exposure = 2;  // the wrong picture is half as bright, and less clipped
        const Diagnosis d = diagnosed(document, wrong);
        INFO(name);
        REQUIRE(is_named(d, {mistake}));
        CHECK(d.display.change.gain == Approx(0.5).epsilon(0.01));
    }
}

TEST_CASE("a difference's wrong pixels are those in its regions, under any display change", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    const PictureSize size{160, 90};
    Renderer renderer(1);
    const Picture right = renderer.render(document.scene, size);
    SECTION("a dimmed light is not reported as a gain") {
        Scene dimmed = document.scene;
        dimmed.lights[0].intensity *= 0.6f;
        const Diagnosis d = diagnosed(document, renderer.render(dimmed, size));
        REQUIRE(d.verdict == Verdict::AnotherNumber);
        CHECK(d.display.change.gain == 1);
        CHECK(count_of(d.pixels, PixelKind::Surface).unlike == 0);
        CHECK(d.candidates[0].name == "/lights/0/intensity");
        CHECK(scene_under(document.scene, d.candidates[0]).lights[0].intensity ==
              Approx(dimmed.lights[0].intensity).epsilon(0.01));
    }
    SECTION("a patch of a different colour in a darker picture is the only difference") {
        Picture patched = through(right, [](double x) { return 0.7 * x; });
        for (int y = 21; y < 32; ++y)
            for (int x = 61; x < 80; ++x) {
                std::uint8_t* const pixel = &patched.rgba[4 * patched.pixel(x, y)];
                pixel[0] = 255, pixel[1] = pixel[2] = 0;
            }
        const Diagnosis d = diagnosed(document, patched);
        REQUIRE(d.verdict == Verdict::NotInCatalogue);
        CHECK(d.display.change.gain == Approx(0.7).epsilon(0.02));
        CHECK(wrong_in_regions(d) == count_of(d.pixels, PixelKind::Surface).unlike);
        CHECK(wrong_in_regions(d) <= 11 * 19);
        CHECK(wrong_in_regions(d) > 11 * 19 * 9 / 10);
        REQUIRE(d.regions.size() == 1);
        CHECK(d.regions[0].low == glm::ivec2(61, 21));
        CHECK(d.regions[0].high == glm::ivec2(79, 31));
    }
}

TEST_CASE("the deciding pixel is reported in the coordinates of a flipped picture", "[diagnose][release]") {
    const SceneDocument document = diagnosed_scene(4);
    const Picture wrong = picture_under(document.scene, {place_of("missing_pi")});
    for (int ways = 0; ways < 8; ++ways) {
        Picture picture = turned_over(wrong, (ways & 1) != 0, (ways & 2) != 0);
        for (std::size_t i = 0; (ways & 4) != 0 && i < picture.rgba.size(); i += 4)
            std::swap(picture.rgba[i], picture.rgba[i + 2]);
        const Diagnosis d = diagnosed(document, picture);
        REQUIRE(d.verdict == Verdict::Mistake);
        const std::string text = diagnosis_text(d, document.scene);
        int x = 0, y = 0, r = 0, g = 0, b = 0;
        const std::size_t at = text.find(" At ");
        INFO("way " << ways << ": " << text);
        REQUIRE(at != std::string::npos);
        REQUIRE(std::sscanf(text.c_str() + at, " At %d,%d your picture has (%d, %d, %d)", &x, &y, &r, &g,
                            &b) == 5);
        const std::uint8_t* const pixel = &picture.rgba[4 * picture.pixel(x, y)];
        CHECK((r == pixel[0] && g == pixel[1] && b == pixel[2]));
    }
}

TEST_CASE("among candidates that explain too little, the best comes first", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    SceneDocument wrong = document;
    wrong.scene.shading.mistakes.normals_left_in_world = wrong.scene.shading.mistakes.missing_pi = true;
    const Diagnosis d = diagnosed(document, Renderer(1).render(wrong.scene, {320, 180}));
    REQUIRE(d.verdict == Verdict::NotInCatalogue);
    REQUIRE(d.candidates.size() > 1);
    CHECK(name_of(d.candidates[0].mistakes) == "normals_left_in_world");  // one of the two mistakes
    for (std::size_t i = 1; i < d.candidates.size(); ++i)
        CHECK(d.candidates[i - 1].explained >= d.candidates[i].explained);
}

TEST_CASE("a fraction above zero is not printed as 0 %", "[diagnose]") {
    CHECK(percent_text(0) == "0 %");
    CHECK(percent_text(1e-6) == "less than 1 %");
    CHECK(percent_text(0.006) == "1 %");
    CHECK(percent_text(1) == "100 %");
}

TEST_CASE("the object with the most wrong pixels, brighter or darker, is reported", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    Renderer renderer(1);
    Picture picture = renderer.render(document.scene, {160, 90});
    std::map<int, int> pixels;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 160; ++x) ++pixels[renderer.object_at(x, y)];
    // One half of the largest object is brighter and one half darker; a few pixels of another object are all
    // brighter.
    pixels.erase(-1);
    const auto by_count = [](const auto& a, const auto& b) { return a.second < b.second; };
    const int large = std::max_element(pixels.begin(), pixels.end(), by_count)->first;
    const int other =
        std::find_if(pixels.begin(), pixels.end(), [&](const auto& p) { return p.first != large; })->first;
    int few = 0;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 160; ++x) {
            const int object = renderer.object_at(x, y);
            const bool is_one_of_few = object == other && few < 60;
            if (object != large && !is_one_of_few) continue;
            few += is_one_of_few;
            const int by = is_one_of_few ? 60 : x < 80 ? 30 : -30;
            for (std::size_t c = 0; c < 3; ++c) {
                std::uint8_t& byte = picture.rgba[4 * picture.pixel(x, y) + c];
                byte = static_cast<std::uint8_t>(std::clamp(int{byte} + by, 0, 255));
            }
        }
    const Diagnosis d = diagnosed(document, picture);
    REQUIRE(d.verdict == Verdict::NotInCatalogue);
    REQUIRE(d.regions.size() > 1);
    CHECK(d.regions[0].object == large);
}
