// Noise from sampling or dithering is not a mistake, and does not hide one.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "diagnose/diagnose.h"
#include "diagnose/diagnosis_format.h"
#include "diagnose/search/probes.h"
#include "diagnose/search/score.h"
#include "models/scene/mistakes.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

/// The picture with normally distributed noise; `deviation` is in levels.
Picture noisy(Picture picture, double deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, deviation);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3)
            picture.rgba[i] = static_cast<std::uint8_t>(
                std::clamp(std::lround(double(picture.rgba[i]) + noise(random)), 0L, 255L));
    return picture;
}

}  // namespace

TEST_CASE("noise is measured, and a clean picture has none", "[diagnose]") {
    const Picture right = picture_under(diagnosed_scene(4).scene, {});
    CHECK(noise_of(right, right) == 0);
    CHECK(noise_of(noisy(right, 0.4, 1), right) == 0);
    for (const double deviation : {1.5, 3.0, 6.0})
        CHECK(double(noise_of(noisy(right, deviation, 2), right)) == Approx(deviation).epsilon(0.2));
    Picture grey = right;
    std::fill(grey.rgba.begin(), grey.rgba.end(), std::uint8_t{128});
    CHECK(noise_of(grey, grey) == 0);
}

TEST_CASE("a correct picture with noise has no mistake", "[diagnose][release]") {
    for (const char* name : {"sun.json", "still-life.json", "default.json"}) {
        const SceneDocument document = shipped(name);
        const Picture right = picture_under(document.scene, {});
        for (const double deviation : {1.0, 2.0, 5.0}) {
            INFO(name << ", noise " << deviation);
            const Diagnosis d = diagnosed(document, noisy(right, deviation, 3));
            CHECK(d.verdict == Verdict::NoMistake);
            CHECK(display_text(d.display).starts_with("noise of about "));
        }
    }
}

TEST_CASE("a picture with too much noise is reported as not comparable", "[diagnose]") {
    const SceneDocument document = shipped("default.json");
    const Diagnosis d = diagnosed(document, noisy(picture_under(document.scene, {}), 20, 5));
    CHECK(d.verdict == Verdict::NotComparable);
    CHECK(d.why.starts_with("noise of about "));
}

TEST_CASE("noise around one colour is not a picture of a scene", "[diagnose]") {
    constexpr std::array names{"sun.json", "still-life.json", "default.json"};
    constexpr std::array levels{0, 40, 128};
    constexpr std::array deviations{2.0, 4.0, 9.0};
    for (std::size_t scene = 0; scene < names.size(); ++scene)
        for (std::size_t i = 0; i < levels.size(); ++i) {  // each pair of values occurs once
            const double deviation = deviations[(scene + i) % deviations.size()];
            const SceneDocument document = shipped(names[scene]);
            Picture grey = picture_under(document.scene, {});
            std::fill(grey.rgba.begin(), grey.rgba.end(), static_cast<std::uint8_t>(levels[i]));
            INFO(names[scene] << ", " << levels[i] << ", noise " << deviation);
            const Diagnosis d = diagnosed(document, noisy(grey, deviation, 6));
            CHECK(d.verdict == Verdict::NotComparable);
            CHECK(d.why.starts_with("it has a single colour except for noise of about "));
        }
}

TEST_CASE("a mistake is named in a noisy picture", "[diagnose][release]") {
    SceneDocument document = shipped("default.json");
    document.scene.shading.reflection = Reflection::Phong;
    for (const char* name : {"reflect_sign", "normals_left_in_world", "encoded_twice", "missing_pi"})
        for (const double deviation : {1.0, 2.0}) {
            const MistakeSet mistake{place_of(name)};
            const Picture wrong = noisy(picture_under(document.scene, mistake), deviation, 4);
            INFO(name << ", noise " << deviation);
            const Diagnosis d = diagnosed(document, wrong);
            CHECK(is_named(d, mistake));
        }
}

// Two mistakes at once, and the report if no pair explains the picture.
namespace {

DiagnosisOptions of_pairs() {
    DiagnosisOptions options;
    options.pairs = true;
    return options;
}

Picture drawn(const Scene& scene, PictureSize size) {
    Renderer renderer(1);
    return renderer.render(scene, size);
}

}  // namespace

TEST_CASE("a mistake with no effect alone is found with one that makes it visible", "[diagnose]") {
    SceneDocument document = diagnosed_scene(2);
    for (Object& object : document.scene.objects) object.material.specular = glm::vec3(0);
    Scene wrong = document.scene;
    wrong.shading.mistakes.unnormalized_view = true;
    REQUIRE(drawn(wrong, diagnosed_size).rgba == drawn(document.scene, diagnosed_size).rgba);
    wrong.shading.mistakes.coefficients_swapped = true;
    const Diagnosis d = diagnose(document, drawn(wrong, diagnosed_size), of_pairs());
    REQUIRE(d.verdict == Verdict::Mistake);
    CHECK(name_of(d.candidates[0].mistakes) == "unnormalized_view + coefficients_swapped");
    CHECK(d.candidates[0].residual == 0);
}

TEST_CASE("two mistakes that make a pattern of faces are found at unusual picture sizes", "[diagnose]") {
    const SceneDocument document = shipped("lost-highlight.json");
    Scene wrong = document.scene;
    wrong.shading.mistakes.some_faces_flipped = wrong.shading.mistakes.normals_as_points = true;
    for (const PictureSize size : {PictureSize{200, 300}, {320, 185}}) {
        const Diagnosis d = diagnose(document, drawn(wrong, size), of_pairs());
        REQUIRE(d.verdict == Verdict::Mistake);
        CHECK(name_of(d.candidates[0].mistakes) == "normals_as_points + some_faces_flipped");
        CHECK(d.candidates[0].residual == 0);
        CHECK(display_text(d.display).empty());
    }
}

TEST_CASE("the report on an unexplained picture says whether pairs were tried", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    Picture picture = drawn(document.scene, diagnosed_size);
    for (std::size_t i = 0; i < picture.rgba.size() / 2; ++i)
        if (i % 4 != 3) picture.rgba[i] = static_cast<std::uint8_t>(255 - picture.rgba[i]);
    const auto says = [&](const DiagnosisOptions& options) {
        const std::string text = diagnosis_text(diagnose(document, picture, options), document.scene);
        return text.substr(0, text.find('\n'));
    };
    CHECK(says({}).ends_with("of the pixels are wrong, and no single mistake explains them."));
    CHECK(says(of_pairs())
              .ends_with("of the pixels are wrong, and no mistake explains them, alone or paired; pairs "
                         "were tried on a small picture."));
}

TEST_CASE("a mistake that explains no wrong pixel is not a candidate", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    Scene wrong = document.scene;
    wrong.shading.mistakes.missing_pi = true;
    const Diagnosis d = diagnosed(document, drawn(wrong, {320, 180}));
    REQUIRE(d.verdict == Verdict::Mistake);
    CHECK(name_of(d.candidates[0].mistakes) == "missing_pi");
    for (const Candidate& candidate : d.candidates) CHECK(explained_percent(candidate) > 0);
}

// Masks of the surfaces that a mistake removes, and how those pixels are compared.
namespace {

/// A ball lit from the side, so that many faces point away from the light.
SceneDocument lit_from_the_side() {
    Scene scene;
    scene.camera.eye = {0, 0, 4};
    scene.global_ambient = {0.3f, 0.3f, 0.3f};
    scene.lights = {Light{}};
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].position = {1, 0.5f, 0.2f, 0};
    scene.objects = {object_of(primitive(Primitive::Sphere, 24))};
    SceneDocument document;
    document.scene = scene;
    return document;
}

Scene under(const Scene& scene, std::initializer_list<bool Mistakes::*> mistakes) {
    Scene wrong = scene;
    for (bool Mistakes::*mistake : mistakes) wrong.shading.mistakes.*mistake = true;
    return wrong;
}

BareMask by_pixels(const Renderer& renderer, PictureSize size) {
    BareMask mask;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) mask.push_back(renderer.object_at(x, y) < 0 ? 1 : 0);
    return mask;
}

}  // namespace

TEST_CASE("a picture's mask does not depend on pictures drawn earlier", "[diagnose]") {
    const Scene scene = lit_from_the_side().scene;
    Renderer renderer(2);
    BareMasks masks;
    (void)renderer.render(scene, diagnosed_size);
    CHECK(masks.of(renderer, diagnosed_size).empty());
    // Two consecutive scenes omit the same faces, so the second one redraws no face.
    for (const auto& mistakes : {under(scene, {&Mistakes::culled_by_light}),
                                 under(scene, {&Mistakes::culled_by_light, &Mistakes::missing_pi})}) {
        (void)renderer.render(mistakes, diagnosed_size);
        const BareMask mask = masks.of(renderer, diagnosed_size);
        CHECK(std::count(mask.begin(), mask.end(), 1) > 1000);
        CHECK(mask == by_pixels(renderer, diagnosed_size));
    }
    (void)renderer.render(under(scene, {&Mistakes::missing_pi}), diagnosed_size);
    CHECK(masks.of(renderer, diagnosed_size).empty());
}

TEST_CASE("culled_by_light is named even if the background differs, alone and in a pair", "[diagnose]") {
    const SceneDocument document = lit_from_the_side();
    for (const bool two : {false, true}) {
        Scene wrong = under(document.scene, {&Mistakes::culled_by_light});
        wrong.shading.mistakes.missing_pi = two;
        wrong.display.background = {0.6f, 0.1f, 0.3f};
        Renderer renderer(2);
        const Picture picture = renderer.render(wrong, diagnosed_size);
        const Diagnosis d = diagnose(document, picture, {.pairs = two});
        CAPTURE(two, d.why);
        REQUIRE(d.verdict == Verdict::Mistake);
        MistakeSet expected;
        for (std::size_t m = 0; m < mistake_names().size(); ++m)
            if (wrong.shading.mistakes.*mistake_names()[m].flag) expected.push_back(m);
        CHECK(d.candidates.front().mistakes == expected);
        // Everything is explained: removed surfaces show the picture's own background.
        CHECK(count_of(d.pixels, PixelKind::Surface).unlike == 0);
        CHECK(d.candidates.front().as_mistaken == d.candidates.front().mine);
        CHECK(d.display.softened == 0);
        CHECK(d.display.shift == glm::vec2(0));
    }
}
