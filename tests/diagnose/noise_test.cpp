// Noise from sampling or dithering is not a mistake, and does not hide one.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "diagnose/diagnose.h"
#include "diagnose/diagnosis_format.h"
#include "diagnose/search/score.h"
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
        for (std::size_t i = 0; i < levels.size(); ++i) {  // every pair of values occurs together once
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
