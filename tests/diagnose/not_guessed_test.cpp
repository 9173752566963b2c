// Pictures that no mistake produced: of one colour, of a different scene in flat colours, clipped or partly
// darkened. A diagnosis must not guess a mistake for them.
#include <algorithm>
#include <cmath>

#include "diagnose/diagnose.h"
#include "diagnose/diagnosis_format.h"
#include "diagnose/search/score.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

Picture right_of(const SceneDocument& document, PictureSize size) {
    Renderer renderer(1);
    return renderer.render(document.scene, size);
}

void fill(Picture& picture, std::uint8_t level) {
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) picture.rgba[i] = level;
}

/// A disc of one colour in front of the scene's background colour.
Picture disc(PictureSize size, std::uint8_t level) {
    Picture picture{size, std::vector<std::uint8_t>(4 * size.pixels(), 255), {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const bool inside = (x - size.width / 2) * (x - size.width / 2) + (y - 30) * (y - 30) < 400;
            const Rgb colour = inside ? Rgb{level, level, level} : Rgb{26, 26, 31};
            for (std::size_t c = 0; c < 3; ++c) picture.rgba[4 * picture.pixel(x, y) + c] = colour[c];
        }
    return picture;
}

}  // namespace

TEST_CASE("a picture of one colour is comparable only with a scene of one colour", "[diagnose]") {
    for (const char* const name : {"sun", "bulb", "cosine-law", "mach-bands"}) {
        const SceneDocument document = shipped(name + std::string(".json"));
        Picture picture = right_of(document, {160, 120});
        for (const int level : {0, 1, 128, 255}) {
            fill(picture, static_cast<std::uint8_t>(level));
            const Diagnosis d = diagnosed(document, picture);
            INFO(name << ", " << level);
            CHECK(d.verdict == Verdict::NotComparable);
            CHECK(d.why.find("it has a single colour, (" + std::to_string(level) + ", ") == 0);
        }
        picture.rgba[4 * 5000] = 60;  // one pixel differs
        CHECK(diagnosed(document, picture).why.find("single colour") == std::string::npos);
    }
    SceneDocument dark = shipped("sun.json");
    dark.scene.lights.clear();
    dark.scene.global_ambient = dark.scene.display.background = glm::vec3(0);
    Picture picture = right_of(dark, {160, 120});
    fill(picture, 0);
    CHECK(diagnosed(dark, picture).verdict == Verdict::NoMistake);
}

TEST_CASE("a picture that shows only emission is reported as lacking all light", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    Scene dark = document.scene;
    dark.lights.clear();
    dark.global_ambient = glm::vec3(0);
    const Diagnosis d = diagnosed(document, picture_under(dark, {}));
    REQUIRE(d.verdict == Verdict::LeftOut);
    CHECK(d.candidates[0].name == "all light");
}

TEST_CASE("a picture of two flat colours has no noise and is not diagnosed as a mistake",
          "[diagnose][release]") {
    for (const char* const name : {"sun", "every-term", "still-life"}) {
        const SceneDocument document = shipped(name + std::string(".json"));
        const Picture right = right_of(document, {320, 180});
        for (const int level : {40, 70, 200}) {
            const Picture picture = disc({320, 180}, static_cast<std::uint8_t>(level));
            INFO(name << ", " << level);
            CHECK(noise_of(picture, right) == 0);
            const Verdict verdict = diagnosed(document, picture).verdict;
            CHECK((verdict == Verdict::NotComparable || verdict == Verdict::NotInCatalogue));
        }
    }
}

TEST_CASE("a small clipped or partly darkened picture is not diagnosed as a mistake", "[diagnose][release]") {
    for (const char* const name : {"classic-materials", "shininess-grid", "phong-and-blinn-exponents"}) {
        const SceneDocument document = shipped(name + std::string(".json"));
        const Picture right = right_of(document, {240, 180});
        const auto check = [&](const char* what, const auto& change) {
            Picture picture = right;
            for (int y = 0; y < 180; ++y)
                for (int x = 0; x < 240; ++x)
                    for (std::size_t c = 0; c < 3; ++c) {
                        std::uint8_t& level = picture.rgba[4 * picture.pixel(x, y) + c];
                        level = static_cast<std::uint8_t>(change(level, x, y));
                    }
            INFO(name << ", " << what);
            CHECK(diagnosed(document, picture).verdict != Verdict::Mistake);
        };
        check("clipped at 200", [](int level, int, int) { return std::min(level, 200); });
        check("clipped at 150", [](int level, int, int) { return std::min(level, 150); });
        check("its right half darkened", [](int level, int x, int) { return x < 120 ? level : level / 2; });
        check("in stripes", [](int level, int, int y) { return y / 8 % 2 == 0 ? level : level * 3 / 4; });
    }
}

namespace {

/// The value of a channel between pixels: bilinear, and clamped at the picture's border.
double between(const Picture& picture, double x, double y, std::size_t channel) {
    const auto at = [&](int u, int v) {
        u = std::clamp(u, 0, picture.size.width - 1);
        v = std::clamp(v, 0, picture.size.height - 1);
        return double(picture.rgba[4 * picture.pixel(u, v) + channel]);
    };
    const int u = static_cast<int>(std::floor(x)), v = static_cast<int>(std::floor(y));
    const double s = x - u, t = y - v;
    return (1 - t) * ((1 - s) * at(u, v) + s * at(u + 1, v)) +
           t * ((1 - s) * at(u, v + 1) + s * at(u + 1, v + 1));
}

/// Whether a candidate has this name, or gives the same picture as an explanation with this name.
bool has_name(const Candidate& c, const std::string& name) {
    return c.name == name || std::find(c.also_named.begin(), c.also_named.end(), name) != c.also_named.end();
}

/// A picture whose channels are `level(x, y, channel)`, rounded and clamped.
template <class Level> Picture picture_of(PictureSize size, const Level& level) {
    Picture picture{size, std::vector<std::uint8_t>(4 * size.pixels(), 255), {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                picture.rgba[4 * picture.pixel(x, y) + c] =
                    static_cast<std::uint8_t>(std::clamp(std::lround(level(x, y, c)), 0L, 255L));
    return picture;
}

}  // namespace

TEST_CASE("a scaled term is found as a changed number, not a mistake, gain and shift", "[diagnose]") {
    constexpr PictureSize size{320, 180};
    const auto check = [size](const SceneDocument& document, const SceneDocument& changed,
                              const std::string& number) {
        const Diagnosis d = diagnosed(document, right_of(changed, size));
        REQUIRE(d.verdict == Verdict::AnotherNumber);
        CHECK(d.display.change == DisplayChange{});
        INFO(d.candidates[0].name);
        CHECK(has_name(d.candidates[0], number));
        CHECK(d.candidates[0].residual < 0.3);
    };
    const SceneDocument floor = shipped("receding-floor.json"), ball = shipped("glossy-ball.json");
    SceneDocument darker = floor;
    darker.scene.global_ambient *= 0.8f;
    check(floor, darker, "/global_ambient");
    SceneDocument weaker = ball;
    weaker.scene.lights[0].intensity *= 0.8f;
    check(ball, weaker, "/lights/0/intensity");
}

TEST_CASE("a brightening mistake with a darkening gain is rejected if most is unchanged", "[diagnose]") {
    // Each light has an ambient share, which one mistake adds twice.
    const Result<Scene> parsed = parse_scene(R"({"glint": 1,
        "camera": {"eye": [2, 2.5, 5], "target": [0, 0.3, 0]}, "global_ambient": [0.15, 0.15, 0.15],
        "lights": [
            {"type": "directional", "position": [1, 2, 1.5], "diffuse": [0.5, 0.45, 0.4], "specular": [0.5, 0.5, 0.5]},
            {"type": "point", "position": [-2, 2, 1.5], "diffuse": [0.6, 0.8, 1], "specular": [0.8, 0.9, 1],
             "intensity": 1.2, "ambient": [0.05, 0.05, 0.05],
             "falloff": {"constant": 1, "linear": 0.1, "quadratic": 0.15}},
            {"type": "spot", "position": [1.5, 3.5, 1], "diffuse": [1, 0.6, 0.3], "specular": [1, 0.6, 0.3],
             "spot": {"direction": [-0.3, -1, -0.2], "cutoff_deg": 25, "exponent": 4},
             "falloff": {"constant": 1, "linear": 0, "quadratic": 0.05}}],
        "objects": [
            {"mesh": {"primitive": "sphere"}, "transform": {"translate": [-1.2, 0.3, 0], "scale": [1, 0.8, 1]},
             "material": {"ambient": [0.6, 0.2, 0.2], "diffuse": [0.6, 0.2, 0.2], "specular": [0.6, 0.6, 0.6],
                          "shininess": 40}},
            {"mesh": {"primitive": "torus"},
             "transform": {"translate": [1.2, 0.2, 0.3], "rotate_deg": [60, 20, 0], "scale": [0.8, 1.2, 0.8]},
             "material": {"ambient": [0.2, 0.5, 0.2], "diffuse": [0.2, 0.5, 0.25], "specular": [0.3, 0.3, 0.3],
                          "shininess": 12}},
            {"mesh": {"primitive": "plane"}, "transform": {"translate": [0, -0.6, 0], "scale": [4, 1, 4]},
             "material": {"ambient": [0.5, 0.5, 0.5], "diffuse": [0.5, 0.5, 0.5], "specular": [0.1, 0.1, 0.1],
                          "shininess": 8}}]})",
                                             "");
    SceneDocument document;
    document.scene = std::get<Scene>(parsed);
    REQUIRE(problem_of(load_meshes(document.scene, "", "")) == nullptr);
    SceneDocument changed = document;
    for (Object& object : changed.scene.objects) object.material.specular *= 0.8f;
    const Diagnosis d = diagnosed(document, right_of(changed, {320, 240}));
    CHECK(d.verdict != Verdict::Mistake);
    CHECK(d.display.change.gain == Approx(1).margin(0.01));
}

TEST_CASE("highlights of a different width are not diagnosed as smoothing", "[diagnose][release]") {
    for (const std::string name : {"still-life", "phong-and-blinn-exponents", "shininess-grid",
                                   "wide-angle-balls", "classic-materials"}) {
        const SceneDocument document = shipped(name + ".json");
        SceneDocument narrower = document;
        for (Object& object : narrower.scene.objects) object.material.shininess *= 1.3f;
        INFO(name);
        const Diagnosis d = diagnosed(document, right_of(narrower, {320, 240}));
        const bool is_one_number = name == "wide-angle-balls";  // all its objects have a shininess of 40
        CHECK(d.verdict == (is_one_number ? Verdict::AnotherNumber : Verdict::NotInCatalogue));
        if (is_one_number) CHECK(settings_of(d).starts_with("/objects/0/material/shininess=52 /objects/1/"));
    }
}

TEST_CASE("smoothing or shifting a correct picture is reported, but not as a mistake",
          "[diagnose][release]") {
    constexpr PictureSize size{320, 240};
    for (const char* const name : {"still-life", "shininess-grid", "wide-angle-balls"}) {
        const SceneDocument document = shipped(name + std::string(".json"));
        const Picture right = right_of(document, size);
        const auto near = [&right](int x, int y, std::size_t c) { return between(right, x, y, c); };
        const Picture smoothed = picture_of(size, [&](int x, int y, std::size_t c) {
            return near(x, y, c) / 2 +
                   (near(x - 1, y, c) + near(x + 1, y, c) + near(x, y - 1, c) + near(x, y + 1, c)) / 8;
        });
        const Picture moved = picture_of(
            size, [&](int x, int y, std::size_t c) { return between(right, x - 0.4, y + 0.3, c); });
        INFO(name);
        const Diagnosis of_smoothed = diagnosed(document, smoothed), of_moved = diagnosed(document, moved);
        CHECK(of_smoothed.verdict == Verdict::NoMistake);
        CHECK(of_smoothed.display.smoothed);
        CHECK(of_moved.verdict == Verdict::NoMistake);
        CHECK(glm::distance(of_moved.display.shift, glm::vec2(0.4f, -0.3f)) < 0.1f);
    }
}

TEST_CASE("a missing highlight is reported as left out, not as a removal of all highlights",
          "[diagnose][release]") {
    {
        const SceneDocument document = shipped("every-term.json");
        SceneDocument dull = document;
        dull.scene.shading.terms.specular = false;
        const Diagnosis d = diagnosed(document, right_of(dull, {480, 270}));
        REQUIRE(d.verdict == Verdict::LeftOut);
        CHECK(d.candidates.front().set == std::vector<std::string>{"/shading/terms/specular=false"});
    }
    const SceneDocument document = shipped("glossy-ball.json");
    SceneDocument dull = document;
    dull.scene.objects[0].material.specular = glm::vec3(0);
    const Diagnosis d = diagnosed(document, right_of(dull, {320, 240}));
    REQUIRE(d.verdict == Verdict::LeftOut);
    CHECK(d.candidates.front().name == "specular term");
    CHECK(diagnosis_text(d, document.scene).starts_with("Left out: specular term."));
}

TEST_CASE("flat and Gouraud shading are found as settings, not as a smoothed Phong picture",
          "[diagnose][release]") {
    const auto check = [](const std::string& name, ShadingMode mode, PictureSize size) {
        const SceneDocument document = shipped(name + ".json");
        SceneDocument other = document;
        other.scene.shading.mode = mode;
        INFO(name);
        const Diagnosis d = diagnosed(document, right_of(other, size));
        CHECK(d.verdict == Verdict::AnotherSetting);
        CHECK(settings_of(d) == (mode == ShadingMode::Flat ? "/shading/mode=flat" : "/shading/mode=gouraud"));
    };
    check("worked-camera", ShadingMode::Gouraud, {640, 400});
    check("worked-camera", ShadingMode::Gouraud, {320, 200});
    check("rough-to-smooth", ShadingMode::Gouraud, {320, 200});
    check("sun-and-headlight", ShadingMode::Gouraud, {640, 400});
    check("every-term", ShadingMode::Flat, {320, 200});
    check("bulb", ShadingMode::Flat, {320, 200});
    check("light-behind-ball", ShadingMode::Flat, {480, 300});
}

TEST_CASE("with hard edges, softness does not explain a changed highlight", "[diagnose][release]") {
    const SceneDocument document = shipped("spot-cone.json");
    SceneDocument other = document;
    other.scene.objects[0].material.shininess = 64;
    for (const PictureSize size : {PictureSize{640, 480}, {480, 300}}) {
        const Diagnosis d = diagnosed(document, right_of(other, size));
        CHECK(d.verdict == Verdict::AnotherNumber);
        CHECK(settings_of(d) == "/objects/0/material/shininess=64");
        CHECK(d.display.softened == 0);
    }
}

TEST_CASE("different sample points in the pixels are found as a shift, even with hard edges",
          "[diagnose][release]") {
    constexpr PictureSize size{320, 240};
    for (const char* const name : {"still-life", "default", "every-term"}) {
        const SceneDocument document = shipped(name + std::string(".json"));
        const Picture fine = right_of(document, {2 * size.width, 2 * size.height});
        Picture picture{size, std::vector<std::uint8_t>(4 * size.pixels(), 255), {}};
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)  // at three quarters of each pixel
                for (std::size_t c = 0; c < 3; ++c)
                    picture.rgba[4 * picture.pixel(x, y) + c] =
                        fine.rgba[4 * fine.pixel(2 * x + 1, 2 * y + 1) + c];
        const Diagnosis d = diagnosed(document, picture);
        INFO(name);
        CHECK(d.verdict == Verdict::NoMistake);
        CHECK(d.display.shift.x == Approx(-0.25).margin(0.03));
        CHECK(d.display.shift.y == Approx(-0.25).margin(0.03));
    }
}

TEST_CASE("a scaled term is found as a changed number, not as a blurred mistake", "[diagnose][release]") {
    const auto check = [](const std::string& name, PictureSize size, const std::string& number,
                          const auto& change) {
        const SceneDocument document = shipped(name + ".json");
        SceneDocument other = document;
        change(other.scene);
        const Diagnosis d = diagnosed(document, right_of(other, size));
        INFO(name);
        REQUIRE(d.verdict == Verdict::AnotherNumber);
        CHECK(d.display.change == DisplayChange{});
        CHECK(has_name(d.candidates[0], number));
        CHECK(d.candidates[0].residual < 0.3);
    };
    check("classic-materials", {320, 200}, "/global_ambient",
          [](Scene& scene) { scene.global_ambient *= 1.5f; });
    check("shininess-grid", {480, 300}, "/lights/0/intensity",
          [](Scene& scene) { scene.lights[0].intensity *= 0.5f; });
}

TEST_CASE("a flip that puts surfaces on the scene's background is rejected", "[diagnose][release]") {
    const SceneDocument document = shipped("inverse-square.json");
    SceneDocument other = document;
    other.scene.shading.reflection = Reflection::OrenNayar;
    const Diagnosis d = diagnosed(document, right_of(other, {480, 300}));
    CHECK(d.verdict == Verdict::AnotherSetting);
    CHECK(settings_of(d) == "/shading/reflection=oren-nayar");
    CHECK_FALSE(d.display.change.upside_down);
}

TEST_CASE("a material's reflection model that a program ignores is named with its object", "[diagnose]") {
    const SceneDocument document = shipped("chalk-and-glaze.json");
    const auto named = [&](auto&& change) {
        SceneDocument other = document;
        change(other.scene);
        const Diagnosis d = diagnosed(document, right_of(other, {320, 200}));
        CHECK(d.verdict == Verdict::AnotherSetting);
        return settings_of(d);
    };
    CHECK(named([](Scene& s) { s.objects[2].material.reflection = OwnReflection::Scene; }) ==
          "/objects/2/material/reflection=blinn-phong");
    CHECK(named([](Scene& s) { s.objects[0].material.reflection = OwnReflection::Lambert; }) ==
          "/objects/0/material/reflection=lambert");
    const auto all_phong = [](Scene& s) {
        s.shading.reflection = Reflection::Phong;
        for (Object& o : s.objects) o.material.reflection = OwnReflection::Scene;
    };
    CHECK(named(all_phong).starts_with("/shading/reflection=phong"));
}

TEST_CASE("if a flip keeps the silhouette, the light is named before the flip", "[diagnose]") {
    SceneDocument document;
    document.scene.objects = {object_of(primitive(Primitive::Sphere, 48))};
    document.scene.camera.eye = {0, 0, 4};
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {1, 1, 1, 0};
    document.scene.lights = {sun};
    const Picture mirrored = turned_over(right_of(document, {320, 240}), false, true);
    const Diagnosis d = diagnosed(document, mirrored);
    REQUIRE(d.verdict == Verdict::AnotherNumber);
    CHECK(d.candidates[0].name == "/lights/0/position");
    const std::vector<std::string>& also = d.candidates[0].also_named;
    CHECK(std::find(also.begin(), also.end(), "the right picture, mirrored") != also.end());
}

TEST_CASE("a declared convention is assumed in every explanation", "[diagnose]") {
    SceneDocument document = diagnosed_scene(2);
    Scene program = document.scene;
    program.shading.local_viewer = false;
    program.shading.mistakes.normals_flipped = true;
    Renderer renderer(1);
    const Picture wrong = renderer.render(program, diagnosed_size);
    const Diagnosis d = diagnose(document, wrong, {.conventions = {"local_viewer"}, .threads = 1});
    REQUIRE(d.verdict == Verdict::Mistake);
    CHECK(name_of(d.candidates[0].mistakes) == "normals_flipped");
    REQUIRE(d.conventions.size() == 1);
    CHECK(d.conventions[0].starts_with("local_viewer"));
}

TEST_CASE("a picture of three colours is not explained as mirrored, darkened and wrong", "[diagnose]") {
    const SceneDocument document = shipped("three-angles.json");
    SceneDocument duller = document;
    duller.scene.objects[0].material.shininess = 2;
    const Diagnosis d = diagnosed(document, right_of(duller, {320, 240}));
    REQUIRE(d.verdict == Verdict::AnotherNumber);
    CHECK(d.display.change == DisplayChange{});
    CHECK(settings_of(d) == "/objects/0/material/shininess=2");
}

TEST_CASE("a candidate's own gain is printed next to its name", "[diagnose]") {
    Diagnosis d;
    d.verdict = Verdict::NotInCatalogue;
    Candidate& nearest = d.candidates.emplace_back();
    nearest.mistakes = {0};
    nearest.change.gain = 0.04f;
    CHECK(own_brightness(d, nearest) == "with brightness multiplied by 0.04");
    CHECK(diagnosis_text(d, Scene{}).find(" with brightness multiplied by 0.04, which explains") !=
          std::string::npos);
    d.display.change.gain = 0.04f;
    CHECK(own_brightness(d, nearest).empty());
    CHECK(diagnosis_text(d, Scene{}).find("brightness multiplied by 0.04, which") == std::string::npos);
}

TEST_CASE("a correct picture that was enlarged or sharpened has no mistake", "[diagnose][release]") {
    for (const char* const name :
         {"given-normals", "classic-materials", "default", "glossy-ball", "mach-bands"}) {
        const SceneDocument document = shipped(name + std::string(".json"));
        const Picture right = right_of(document, {320, 180});
        const auto check = [&](const char* what, const Picture& picture) {
            INFO(name << ", " << what);
            CHECK(diagnosed(document, picture).verdict != Verdict::Mistake);
        };
        for (const int percent : {150, 300})
            check("enlarged",
                  picture_of({320 * percent / 100, 180 * percent / 100}, [&](int x, int y, std::size_t c) {
                      return between(right, (x + 0.5) * 100 / percent - 0.5, (y + 0.5) * 100 / percent - 0.5,
                                     c);
                  }));
        for (const double amount : {1.5})
            check("sharpened", picture_of(right.size, [&](int x, int y, std::size_t c) {
                      double around = 0;
                      for (int v = -1; v <= 1; ++v)
                          for (int u = -1; u <= 1; ++u) around += between(right, x + u, y + v, c) / 9;
                      const double here = between(right, x, y, c);
                      return here + amount * (here - around);
                  }));
    }
}
