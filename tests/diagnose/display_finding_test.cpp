// Changes at the display are found and named: flips, swapped channels, gains, encodings, shifts.
#include <fmt/format.h>

#include <cmath>

#include "diagnose/diagnose.h"
#include "diagnose/diagnosis_format.h"
#include "diagnose/search/display_change.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

SceneDocument bright_scene() {
    SceneDocument document = diagnosed_scene(2);
    document.scene.display.background = {0.3f, 0.1f, 0.5f};
    return document;
}

DisplayFinding finding_of(const SceneDocument& document, const Picture& picture) {
    const Diagnosis d = diagnosed(document, picture);
    CHECK(d.verdict == Verdict::NoMistake);
    return d.display;
}

Picture exchanged(Picture picture) {
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) std::swap(picture.rgba[i], picture.rgba[i + 2]);
    return picture;
}

/// Each pixel becomes the mean of itself and its neighbours above, to the left, and above left: a shift by
/// half a pixel down and right.
Picture shifted(const Picture& picture) {
    Picture moved = picture;
    for (int y = 1; y < picture.size.height; ++y)
        for (int x = 1; x < picture.size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                int sum = 2;
                for (const auto& [u, v] : {std::pair{x, y}, {x - 1, y}, {x, y - 1}, {x - 1, y - 1}})
                    sum += int{picture.rgba[4 * picture.pixel(u, v) + c]};
                moved.rgba[4 * picture.pixel(x, y) + c] = static_cast<std::uint8_t>(sum / 4);
            }
    return moved;
}

/// Each pixel becomes the mean of the 3 x 3 pixels around it.
Picture blurred(const Picture& picture) {
    Picture soft = picture;
    for (int y = 1; y + 1 < picture.size.height; ++y)
        for (int x = 1; x + 1 < picture.size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                int sum = 4;
                for (int v = y - 1; v <= y + 1; ++v)
                    for (int u = x - 1; u <= x + 1; ++u)
                        sum += int{picture.rgba[4 * picture.pixel(u, v) + c]};
                soft.rgba[4 * picture.pixel(x, y) + c] = static_cast<std::uint8_t>(sum / 9);
            }
    return soft;
}

/// Each pixel becomes a copy of its left neighbour.
Picture one_to_the_right(const Picture& picture) {
    Picture moved = picture;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 1; x < picture.size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                moved.rgba[4 * picture.pixel(x, y) + c] = picture.rgba[4 * picture.pixel(x - 1, y) + c];
    return moved;
}

}  // namespace

TEST_CASE("flips and swapped colour channels are found", "[diagnose]") {
    const SceneDocument document = bright_scene();
    const Picture right = picture_under(document.scene, {});
    CHECK(finding_of(document, right).change == DisplayChange{});
    DisplayChange expected;
    expected.upside_down = true;
    CHECK(finding_of(document, turned_over(right, true, false)).change == expected);
    expected.mirrored = true;
    CHECK(finding_of(document, turned_over(right, true, true)).change == expected);
    expected = {};
    expected.red_blue = true;
    CHECK(finding_of(document, exchanged(right)).change == expected);
}

TEST_CASE("a gain and an encoding are found together", "[diagnose]") {
    const SceneDocument document = bright_scene();
    const Picture right = picture_under(document.scene, {});
    CHECK(finding_of(document, through(right, [](double x) { return 0.7 * x; })).change.gain ==
          Approx(0.7).epsilon(0.01));
    // A second encoding is a mistake in the catalogue; the gain remains.
    const Diagnosis both =
        diagnosed(document, through(right, [](double x) { return srgb_of_linear(0.6 * x); }));
    REQUIRE(both.verdict == Verdict::Mistake);
    CHECK(name_of(both.candidates[0].mistakes) == "encoded_twice");
    const DisplayChange& left = both.display.change;
    CAPTURE(left.encodings(), left.gain, static_cast<int>(left.before), static_cast<int>(left.after));
    CHECK(left.encodings() == 0);
    CHECK(std::pow(left.gain, left.after == Code::Same ? 2.4f : 1.0f) == Approx(0.6).epsilon(0.1));
    Scene encoded = document.scene;
    encoded.display.transfer = Transfer::Srgb;
    SceneDocument srgb;
    srgb.scene = encoded;
    CHECK(finding_of(srgb, right).change.encodings() == -1);
}

namespace {

/// The scene's picture at that exposure.
Picture exposed(const SceneDocument& document, float exposure, PictureSize size, int samples = 1) {
    Scene scene = document.scene;
    scene.display.exposure = exposure;
    Renderer renderer(1);
    return renderer.render(scene, size, false, samples);
}

}  // namespace

TEST_CASE("a gain that also explains the background is preferred to a mistake", "[diagnose]") {
    const SceneDocument document = shipped("red-light-on-green.json");  // two lights, so half is the average
    const Diagnosis d = diagnosed(document, exposed(document, 0.5f, {160, 120}));
    CHECK(d.verdict == Verdict::NoMistake);
    CHECK(d.display.change.gain == Approx(0.5).epsilon(0.01));
    CHECK_FALSE(d.display.background);
}

TEST_CASE("a gain is reported in linear light or in levels, whichever matches better", "[diagnose]") {
    SceneDocument document = shipped("default.json");
    document.scene.display.transfer = Transfer::Srgb;
    const Diagnosis d = diagnosed(document, exposed(document, 1.3f, {200, 150}));
    CHECK(d.verdict == Verdict::NoMistake);
    CHECK(d.display.change.gain == Approx(1.3).epsilon(0.01));  // as a gain in levels it would be 1.13
}

TEST_CASE("a background difference that the mistake itself causes is not reported", "[diagnose]") {
    const SceneDocument document = shipped("bulb.json");
    Scene scene = document.scene;
    scene.shading.mistakes.encoded_twice = true;
    const Diagnosis d = diagnosed(document, Renderer(1).render(scene, {160, 120}));
    REQUIRE(d.verdict == Verdict::Mistake);
    CHECK(name_of(d.candidates[0].mistakes) == "encoded_twice");
    CHECK_FALSE(d.display.background);
}

TEST_CASE("hard edges stay hard in a darker picture, and smooth edges are not a mistake", "[diagnose]") {
    const SceneDocument ball = shipped("default.json");
    CHECK_FALSE(finding_of(ball, exposed(ball, 0.6f, {100, 75})).smooth_edges);
    // Many pixels are clamped; their brightness before the gain is unknown.
    const SceneDocument spot = shipped("light-behind-ball.json");
    const Diagnosis d = diagnosed(spot, exposed(spot, 0.8f, {200, 150}, 4));
    CHECK(d.verdict == Verdict::NoMistake);
    CHECK(d.display.smooth_edges);
}

TEST_CASE("the deciding pixel shows the mistake's colour, even in a clamped picture", "[diagnose]") {
    for (const auto& [name, mistake] : {std::pair("mirror-vector.json", &Mistakes::shininess_inverted),
                                        std::pair("spot-cone.json", &Mistakes::aim_stays_at_origin)}) {
        CAPTURE(name);
        SceneDocument document = shipped(name);
        SceneDocument wrong = document;
        wrong.scene.shading.mistakes.*mistake = true;
        const Diagnosis d = diagnosed(document, exposed(wrong, 0.6f, {200, 150}));
        REQUIRE(d.verdict == Verdict::Mistake);
        const Candidate& c = d.candidates[0];
        CHECK(c.residual < 0.01);
        int off = 0, off_right = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            off = std::max(off, std::abs(int{c.mine[i]} - int{c.as_mistaken[i]}));
            off_right = std::max(off_right, std::abs(int{c.mine[i]} - int{c.reference[i]}));
        }
        CHECK(off <= 1);
        CHECK(off_right > 20);
    }
}

TEST_CASE("a search for two mistakes still finds an explanation without any mistake", "[diagnose]") {
    const SceneDocument document = shipped("mach-bands.json");
    DiagnosisOptions options;
    options.pairs = true;
    const Diagnosis d = diagnose(document, exposed(document, 0.85f, {200, 150}), options);
    CHECK(d.verdict == Verdict::NoMistake);
    CHECK(d.display.change.gain == Approx(0.85).epsilon(0.01));
    const SceneDocument sun = shipped("sun.json");
    SceneDocument flipped = sun;
    flipped.scene.shading.mistakes.some_faces_flipped = true;
    const Diagnosis one = diagnose(sun, exposed(flipped, 0.85f, {200, 150}), options);
    REQUIRE(one.verdict == Verdict::Mistake);
    CHECK(name_of(one.candidates[0].mistakes) == "some_faces_flipped");
}

TEST_CASE("a different background, smooth edges and a half-pixel shift are found", "[diagnose]") {
    const SceneDocument document = bright_scene();
    const Picture right = picture_under(document.scene, {});
    CHECK_FALSE(finding_of(document, right).background);
    CHECK_FALSE(finding_of(document, right).smooth_edges);
    Scene green = document.scene;
    green.display.background = {0, 1, 0};
    CHECK(finding_of(document, picture_under(green, {})).background == Rgb{0, 255, 0});
    Renderer renderer(1);
    CHECK(finding_of(document, renderer.render(document.scene, diagnosed_size, false, 8)).smooth_edges);
    const DisplayFinding moved = finding_of(document, shifted(right));
    CHECK(moved.shift.x == Approx(0.5).margin(0.15));
    CHECK(moved.shift.y == Approx(0.5).margin(0.15));
    CHECK_FALSE(moved.smoothed);
}

TEST_CASE("a one-pixel move is reported as a shift, blurring as smoothing", "[diagnose]") {
    const SceneDocument document = bright_scene();
    const Picture right = picture_under(document.scene, {});
    const Diagnosis moved = diagnosed(document, one_to_the_right(right));
    CHECK(moved.display.shift.x == Approx(1).margin(0.3));
    CHECK(moved.display.shift.y == 0);
    CHECK_FALSE(moved.display.smoothed);
    const DisplayFinding soft = finding_of(document, blurred(right));
    CHECK(soft.smoothed);
    CHECK(soft.shift == glm::vec2(0));
}

TEST_CASE("a shift is measured by iteration, not by one linear step", "[diagnose][release]") {
    const SceneDocument document = shipped("still-life.json");
    Renderer renderer(1);
    const Picture right = renderer.render(document.scene, {160, 90});
    Picture picture = through(right, [](double x) { return 0.95 * x; });
    for (int pixels = 1; pixels <= 3; ++pixels) {
        picture = one_to_the_right(picture);
        const Diagnosis d = diagnosed(document, picture);
        INFO(pixels);
        CHECK(d.display.shift.x == Approx(pixels).margin(0.1));
        CHECK(std::abs(d.display.shift.y) < 0.1f);
    }
}

TEST_CASE("strokes over the background do not change the background or outline", "[diagnose]") {
    SceneDocument document = bright_scene();
    document.scene.npr.silhouettes = true;
    document.scene.npr.stroke_width_px = 12;
    Renderer renderer(1);
    const std::vector<PixelKind> kinds = [&] {
        (void)renderer.render(document.scene, diagnosed_size);
        return pixel_kinds(renderer, diagnosed_size);
    }();
    const Picture right = picture_under(document.scene, {});
    const Rgb background = rgb_at(right, 0);
    std::size_t bare = 0, covered = 0;  // pixels that show no surface
    for (int y = 0; y < diagnosed_size.height; ++y)
        for (int x = 0; x < diagnosed_size.width; ++x) {
            const std::size_t i = diagnosed_size.index(x, y);
            if (renderer.object_at(x, y) < 0) (rgb_at(right, i) == background ? bare : covered) += 1;
            if (kinds[i] == PixelKind::Background) CHECK(rgb_at(right, i) == background);
        }
    REQUIRE(covered > bare / 50);  // otherwise the strokes would not count as a different outline
    const Diagnosis same = diagnosed(document, right);
    CHECK(same.verdict == Verdict::NoMistake);
    CHECK(count_of(same.pixels, PixelKind::Background).unlike == 0);
    CHECK_FALSE(same.display.background);

    Scene unexplained = document.scene;  // will have a different material and a mistake
    unexplained.objects[0].material.diffuse = {0.1f, 0.9f, 0.3f};
    unexplained.objects[0].material.shininess = 3;
    const Diagnosis other =
        diagnosed(document, picture_under(unexplained, {place_of("normals_left_in_world")}));
    INFO(other.why);
    CHECK(other.verdict != Verdict::NotComparable);
}

TEST_CASE("pixels explained only by softness are counted, with a hint about highlights", "[diagnose]") {
    const SceneDocument document = shipped("every-term.json");
    Renderer renderer(1);
    const PictureSize size{160, 90};
    const Picture right = renderer.render(document.scene, size);
    const std::vector<PixelKind> kinds = pixel_kinds(renderer, size);
    const Picture picture = one_to_the_right(right);
    std::uint64_t pixels = 0;
    int most = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] != PixelKind::Surface) continue;
        int off = 0;
        for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
            off = std::max(off, std::abs(int{right.rgba[c]} - int{picture.rgba[c]}));
        pixels += off > 2 ? 1 : 0;
        most = std::max(most, off);
    }
    const Diagnosis d = diagnosed(document, picture);
    CHECK(d.verdict == Verdict::NoMistake);
    CHECK(d.display.softened == pixels);
    CHECK(d.display.softened_most == most);
    const std::string text = diagnosis_text(d, document.scene);
    CHECK(text.find(fmt::format("within surfaces by up to {} levels in {} pixels", most, pixels)) !=
          std::string::npos);
    CHECK(text.find("A small highlight that is lit differently") != std::string::npos);
    CHECK(diagnosis_text(diagnosed(document, right), document.scene).find("highlight") == std::string::npos);
}

TEST_CASE("a small weaker highlight is reported as a changed number, not as smoothing", "[diagnose]") {
    const SceneDocument document = shipped("every-term.json");
    Scene dimmed = document.scene;
    dimmed.lights[0].specular = glm::vec3(0.3f);
    Renderer renderer(1);
    const Diagnosis d = diagnosed(document, renderer.render(dimmed, {160, 90}));
    REQUIRE(d.verdict == Verdict::AnotherNumber);
    CHECK(d.candidates[0].name == "/lights/0/specular");
    CHECK(scene_under(document.scene, d.candidates[0]).lights[0].specular.x == Approx(0.3).margin(0.02));
}

TEST_CASE("a picture of a different aspect ratio is not comparable, its stretch is reported", "[diagnose]") {
    SceneDocument document = bright_scene();
    Renderer renderer(1);
    const Picture wide = renderer.render(document.scene, {320, 180});
    Picture squeezed{diagnosed_size, std::vector<std::uint8_t>(4 * diagnosed_size.pixels(), 255), {}};
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                squeezed.rgba[4 * squeezed.pixel(x, y) + c] = wide.rgba[4 * wide.pixel(2 * x, y * 3 / 2) + c];
    const Diagnosis d = diagnosed(document, squeezed);
    CHECK(d.verdict == Verdict::NotComparable);
    INFO(d.why);
    CHECK(d.why.find("stretched by 0.75") != std::string::npos);
    CHECK(d.candidates.empty());
}

TEST_CASE("the correct picture of every scene in assets/ has no mistake", "[diagnose][release]") {
    for (const std::string& path : asset_scenes()) {
        INFO(path);
        const auto document = std::get<SceneDocument>(open_document(path));
        const Diagnosis d = diagnosed(document, Renderer(1).render(document.scene, {224, 126}));
        CHECK(diagnosis_text(d, document.scene) ==
              "No mistake: the picture shows the scene as Glint does.\n");
    }
}

TEST_CASE("a border is removed, but not the background around an object", "[diagnose]") {
    for (const std::string& path : asset_scenes()) {
        INFO(path);
        const Scene scene = std::get<SceneDocument>(open_document(path)).scene;
        CHECK_THAT(as_arrived(picture_under(scene, {}), scene).words, !Catch::Contains("border"));
    }
    const Scene scene = bright_scene().scene;
    const Picture correct = picture_under(scene, {});
    Picture letterbox = correct;
    letterbox.size.height += 40;
    const std::size_t bar = 20 * 4 * static_cast<std::size_t>(correct.size.width);
    letterbox.rgba.insert(letterbox.rgba.begin(), bar, 9);
    letterbox.rgba.insert(letterbox.rgba.end(), bar, 9);
    CHECK(as_arrived(letterbox, scene).picture.rgba == correct.rgba);
}

TEST_CASE("changes at the display are undone", "[diagnose]") {
    // Worked out by hand: two pixels in a row, mirrored, with red and blue swapped, and twice as bright.
    const Picture wrong{{2, 1}, {20, 40, 60, 255, 100, 120, 140, 255}, {}};
    DisplayChange change;
    change.mirrored = change.red_blue = true;
    change.gain = 2;
    CHECK(undone(wrong, change).rgba == std::vector<std::uint8_t>{70, 60, 50, 255, 30, 20, 10, 255});
    CHECK(undone(wrong, {}).rgba == wrong.rgba);
}

TEST_CASE("byte_ranges() gives the levels that a byte may have had before a display change", "[diagnose]") {
    DisplayChange encoded;
    encoded.before = Code::Encoded;
    // Linear 0.5 is 0.7354 encoded, level 187.5; its neighbours half a level away give 187.4 and 187.6.
    CHECK(byte_ranges(encoded)[128].middle == Approx(188.0).margin(0.6));
    CHECK(byte_ranges(encoded)[0].low <= 0);
    CHECK(byte_ranges(DisplayChange{})[77].distance(80) == 3);
    DisplayChange dimmed;
    dimmed.gain = 0.5f;
    CHECK(byte_ranges(dimmed)[100].distance(50) == 0);
    CHECK(byte_ranges(dimmed)[100].distance(53) > 2);
    CHECK(byte_ranges(dimmed)[255].distance(200) == 0);  // a clamped pixel may have been brighter
}

TEST_CASE("an incorrect term that no mistake in the catalogue explains is found", "[diagnose]") {
    SceneDocument document = bright_scene();
    document.scene.lights = {assorted_lights()[0], assorted_lights()[1]};
    document.scene.global_ambient = glm::vec3(0.25f);
    Scene wrong = document.scene;
    for (Light& light : wrong.lights) light.diffuse *= 0.6f;  // changes more than one number in the scene
    const Diagnosis d = diagnosed(document, picture_under(wrong, {}));
    CHECK(d.verdict == Verdict::NotInCatalogue);
    REQUIRE_FALSE(d.terms.empty());
    CHECK(d.terms[0].term == "diffuse");
    CHECK(d.terms[0].light == all_lights);
    CHECK(d.terms[0].factor == Approx(0.6).margin(0.03));
    CHECK(diagnosis_text(d, document.scene).find("the diffuse term of all lights") != std::string::npos);
}
