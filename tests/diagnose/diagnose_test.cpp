// Diagnoses pictures that the engine draws with mistakes, with different changes at the display. No mistake
// may be found in correct pictures or pictures of other scenes.
#include "diagnose/diagnose.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "diagnose/diagnosis_format.h"
#include "models/progress.h"
#include "models/scene/mistakes.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

/// Counts pictures, those whose mistake the first candidate names, and those that one of three names.
struct Named {
    int all = 0, first = 0, among_three = 0;
    std::string missed;  // mistakes that the first candidate does not name
};

bool names(const Candidate& c, const MistakeSet& mistakes) {
    return c.mistakes == mistakes || std::find(c.also.begin(), c.also.end(), mistakes) != c.also.end();
}

void diagnose_one(Named& named, const SceneDocument& document, const MistakeSet& mistakes, unsigned seed) {
    const WrongPicture wrong = wrong_picture(document.scene, mistakes, seed);
    if (!wrong.differs) return;
    const Diagnosis d = diagnose(document, wrong.picture, {.pairs = mistakes.size() > 1, .threads = 1});
    const bool first = is_named(d, mistakes);
    ++named.all;
    named.first += first ? 1 : 0;
    const auto has_name = [&](const Candidate& c) { return names(c, mistakes); };
    const bool among_three = first || (d.verdict == Verdict::Mistake &&
                                       std::any_of(d.candidates.begin(), d.candidates.end(), has_name));
    named.among_three += among_three ? 1 : 0;
    if (!first) named.missed += name_of(mistakes) + " (" + wrong.what + ", " + std::to_string(seed) + "); ";
}

/// GLINT_DIAGNOSED_SCENES sets a larger number of scenes, which takes longer.
unsigned scenes(unsigned usual) {
    const char* const asked = std::getenv("GLINT_DIAGNOSED_SCENES");
    return asked != nullptr ? static_cast<unsigned>(std::atoi(asked)) : usual;
}

}  // namespace

TEST_CASE("the mistake in a wrong picture is named first", "[diagnose][long][release]") {
    Named named;
    for (unsigned seed = 1; seed <= scenes(5); ++seed) {
        const SceneDocument document = diagnosed_scene(seed);
        for (std::size_t m = 0; m < mistake_names().size(); ++m)
            diagnose_one(named, document, {m}, 100 * seed + static_cast<unsigned>(m));
    }
    INFO(named.first << " first and " << named.among_three << " among three of " << named.all
                     << "; missed: " << named.missed);
    CHECK(named.all > 90);
    CHECK(100 * named.first >= 95 * named.all);
    CHECK(100 * named.among_three >= 99 * named.all);
}

TEST_CASE("two mistakes at once are named together", "[diagnose][long][release]") {
    Named named;
    for (unsigned seed = 1; seed <= scenes(6); ++seed) {
        const SceneDocument document = diagnosed_scene(100 + seed);
        const std::size_t n = mistake_names().size();
        for (unsigned k = 0; k < 5; ++k) {
            const std::size_t a = (7 * k + 3 * seed) % n, b = (a + 1 + (5 * k + seed) % (n - 1)) % n;
            const Scene& scene = document.scene;
            // If one hides the other or is invisible, they do not count as two mistakes.
            const Picture both = picture_under(scene, {a, b});
            if (!differ(both, picture_under(scene, {a})) || !differ(both, picture_under(scene, {b})))
                continue;
            diagnose_one(named, document, {std::min(a, b), std::max(a, b)}, 100 * seed + k);
        }
    }
    INFO(named.first << " of " << named.all << "; missed: " << named.missed);
    CHECK(named.all >= 10);
    CHECK(100 * named.first >= 80 * named.all);
}

TEST_CASE("a correct picture has no mistake under any change at the display", "[diagnose][release]") {
    int all = 0, right = 0;
    for (unsigned seed = 1; seed <= scenes(12); ++seed)
        for (unsigned change = 0; change < 2; ++change) {
            const SceneDocument document = diagnosed_scene(200 + seed);
            const WrongPicture picture = wrong_picture(document.scene, {}, 2 * seed + change);
            const Diagnosis d = diagnosed(document, picture.picture);
            // Encoding once too often is a mistake in the catalogue, so it may be named.
            const bool encoded = picture.what == "sRGB" && d.verdict == Verdict::Mistake &&
                                 name_of(d.candidates[0].mistakes) == "encoded_twice";
            ++all;
            right += d.verdict == Verdict::NoMistake || encoded ? 1 : 0;
        }
    CHECK(100 * right >= 99 * all);
}

TEST_CASE("a picture of a different scene is either not in the catalogue or not comparable",
          "[diagnose][release]") {
    int all = 0, refused = 0;
    for (unsigned seed = 1; seed <= scenes(20); ++seed) {
        const SceneDocument document = diagnosed_scene(300 + seed);
        Scene other = document.scene;
        for (Object& o : other.objects) o.material.diffuse = {0.9f - o.material.diffuse.x, 0.4f, 0.1f};
        for (const Scene& drawn : {diagnosed_scene(900 + seed).scene, other}) {
            const Picture picture = picture_under(drawn, {});
            if (!differ(picture, picture_under(document.scene, {}))) continue;  // lit only by highlights
            const Diagnosis d = diagnosed(document, picture);
            ++all;
            refused += d.verdict == Verdict::NotInCatalogue || d.verdict == Verdict::NotComparable ? 1 : 0;
        }
    }
    CHECK(100 * refused >= 95 * all);
}

TEST_CASE("a mistake that a change at the display undoes is not a candidate", "[diagnose]") {
    const SceneDocument document = diagnosed_scene(2);
    Picture wrong = picture_under(document.scene, {});
    std::size_t brightened = 0;  // pixels in a block that no mistake in the catalogue produces
    Renderer renderer(1);
    (void)renderer.render(document.scene, diagnosed_size);
    for (int y = 50; y < 70; ++y)
        for (int x = 60; x < 100; ++x) {
            if (renderer.object_at(x, y) < 0) continue;
            ++brightened;
            std::uint8_t& green = wrong.rgba[4 * wrong.pixel(x, y) + 1];
            green = static_cast<std::uint8_t>(green < 128 ? green + 40 : green - 40);
        }
    REQUIRE(brightened > 200);
    const Diagnosis d = diagnosed(document, wrong);
    CHECK(d.verdict == Verdict::NotInCatalogue);
    for (const Candidate& c : d.candidates) CHECK(name_of(c.mistakes) != "encoded_twice");
}

TEST_CASE("a power of 2.2 in a correct picture is reported, but not as a mistake", "[diagnose][release]") {
    for (unsigned seed = 1; seed <= scenes(6); ++seed)
        for (const Transfer transfer : {Transfer::Srgb, Transfer::None}) {
            SceneDocument document = diagnosed_scene(400 + seed);
            document.scene.display.transfer = transfer;
            Picture wrong = turned_over(picture_under(document.scene, {}), seed % 2 == 0, false);
            for (std::size_t i = 0; i < wrong.rgba.size(); ++i) {
                const double x = wrong.rgba[i] / 255.0;  // IEC 61966-2-1, back to linear
                const double back = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
                const double linear = transfer == Transfer::Srgb ? back : x;
                if (i % 4 == 3) continue;
                wrong.rgba[i] = static_cast<std::uint8_t>(std::lround(255 * std::pow(linear, 1 / 2.2)));
            }
            const Diagnosis d = diagnosed(document, wrong);
            CAPTURE(seed, transfer, d.candidates.empty() ? "" : name_of(d.candidates[0].mistakes));
            CHECK(d.verdict == Verdict::NoMistake);
            CHECK(d.display.change.is_by_power());
            CHECK(diagnosis_text(d, document.scene).find("by a power of 2.2") != std::string::npos);
            CHECK(d.display.change.encodings() == (transfer == Transfer::Srgb ? 0 : 1));
        }
}

TEST_CASE("a mistake that leaves most of the difference unexplained is not the verdict",
          "[diagnose][release]") {
    // The normals of an egg are wrong. Thin lines across the wall differ by more than the egg.
    const PictureSize size{320, 240};
    SceneDocument document;
    Scene& scene = document.scene;
    scene.camera.eye = {0, 0, 6};
    scene.lights = {assorted_lights()[0]};
    scene.lights[0].position = {0.5f, 1, 1, 0};
    Object wall = object_of(primitive(Primitive::Plane, 1)),
           egg = object_of(primitive(Primitive::Sphere, 32));
    wall.transform = {{0, 0, -1}, {90, 0, 0}, {9, 9, 9}};
    egg.transform.scale = {0.5f, 0.43f, 0.5f};
    scene.objects = {wall, egg};
    Scene mistaken = scene;
    mistaken.shading.mistakes.normals_by_model_matrix = true;
    Picture wrong = Renderer(1).render(mistaken, size);
    const Diagnosis whole = diagnosed(document, wrong);
    REQUIRE(whole.verdict == Verdict::Mistake);
    CHECK(name_of(whole.candidates.front().mistakes) == "normals_by_model_matrix");
    for (const int y : {30, 60, 210})
        for (int x = 10; x < 255; ++x)
            for (std::size_t c = 0; c < 3; ++c) wrong.rgba[4 * wrong.pixel(x, y) + c] ^= 0x40;
    const Diagnosis partly = diagnosed(document, wrong);
    CHECK(partly.verdict == Verdict::NotInCatalogue);
}

TEST_CASE("the diagnosis is the same on one thread and on many", "[diagnose]") {
    const SceneDocument document = diagnosed_scene(3);
    const Picture wrong = picture_under(document.scene, {2, 10});
    for (const bool pairs : {false, true}) {
        const Diagnosis one = diagnose(document, wrong, {.pairs = pairs, .threads = 1});
        const Diagnosis many = diagnose(document, wrong, {.pairs = pairs, .threads = 4});
        REQUIRE(one.candidates.size() == many.candidates.size());
        for (std::size_t i = 0; i < one.candidates.size(); ++i) {
            CHECK(one.candidates[i].mistakes == many.candidates[i].mistakes);
            CHECK(one.candidates[i].residual == many.candidates[i].residual);
            CHECK(one.candidates[i].pixel == many.candidates[i].pixel);
        }
    }
}

TEST_CASE("an exception from the progress callback ends the diagnosis", "[diagnose]") {
    const SceneDocument document = diagnosed_scene(3);
    Renderer renderer(1);
    const Picture right = renderer.render(document.scene, diagnosed_size);
    int calls = 0;
    DiagnosisOptions options;
    options.progress = [&calls](std::size_t done, std::size_t all) {
        CHECK(done < all);
        if (++calls == 5) throw LoadCancelled();
    };
    CHECK_THROWS_AS(diagnose(document, right, options), LoadCancelled);
    CHECK(calls == 5);
}

TEST_CASE("mistakes differ at an experiment's pixel and at all of its neighbours", "[diagnose]") {
    const std::vector<MistakeSet> sets{{place_of("normals_left_in_world")}, {place_of("view_reversed")}};
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const SceneDocument document = diagnosed_scene(seed);
        const auto e = find_experiment(document, diagnosed_size, sets, 1);
        if (!e) continue;
        const auto changed = scene_variant(document, e->set);
        REQUIRE(problem_of(changed) == nullptr);
        const Picture a = picture_under(std::get<Scene>(changed), sets[0]);
        const Picture b = picture_under(std::get<Scene>(changed), sets[1]);
        CHECK(rgb_at(a, a.pixel(e->pixel.x, e->pixel.y)) == e->shows[0]);
        for (int y = e->pixel.y - 1; y <= e->pixel.y + 1; ++y)
            for (int x = e->pixel.x - 1; x <= e->pixel.x + 1; ++x)
                if (x >= 0 && y >= 0 && x < diagnosed_size.width && y < diagnosed_size.height)
                    CHECK(rgb_at(a, a.pixel(x, y)) != rgb_at(b, b.pixel(x, y)));
    }
}

TEST_CASE("a search for an experiment ends when it is cancelled", "[diagnose]") {
    LoadProgress progress;
    const ProgressScope scope(progress);
    const std::vector<MistakeSet> sets{{place_of("normals_flipped")}, {place_of("encoded_twice")}};
    CHECK(find_experiment(diagnosed_scene(3), diagnosed_size, sets, 1));
    progress.cancelled = true;
    CHECK_THROWS_AS(find_experiment(diagnosed_scene(3), diagnosed_size, sets, 1), LoadCancelled);
}

TEST_CASE("the deciding pixel is reported with the colours of both pictures", "[diagnose]") {
    const SceneDocument document = diagnosed_scene(4);
    const std::size_t flipped = place_of("normals_flipped");
    const Picture right = picture_under(document.scene, {}), wrong = picture_under(document.scene, {flipped});
    const Diagnosis d = diagnosed(document, wrong);
    REQUIRE(d.verdict == Verdict::Mistake);
    const Candidate& c = d.candidates.front();
    CHECK(c.mistakes == MistakeSet{flipped});
    CHECK(c.residual == 0);
    CHECK(c.explained == 1);
    CHECK(c.mine == rgb_at(wrong, wrong.pixel(c.pixel.x, c.pixel.y)));
    CHECK(c.as_mistaken == c.mine);
    CHECK(c.reference == rgb_at(right, right.pixel(c.pixel.x, c.pixel.y)));
    CHECK(c.reference != c.mine);
}

TEST_CASE("an experiment shows the reported colours and distinguishes the mistakes", "[diagnose]") {
    const SceneDocument document = diagnosed_scene(5);
    int experiments = 0;
    for (const std::size_t mistake : {0, 2, 4, 7, 10, 12, 18, 24, 27, 30, 33, 36, 41, 45}) {
        const Diagnosis d = diagnosed(document, picture_under(document.scene, {mistake}));
        if (!d.experiment) continue;
        ++experiments;
        const Experiment& e = *d.experiment;
        const auto varied = scene_variant(document, e.set);
        REQUIRE(problem_of(varied) == nullptr);
        REQUIRE(e.mistakes.size() >= 2);
        for (std::size_t i = 0; i < e.mistakes.size(); ++i) {
            const Picture picture = picture_under(std::get<Scene>(varied), e.mistakes[i]);
            CHECK(rgb_at(picture, picture.pixel(e.pixel.x, e.pixel.y)) == e.shows[i]);
        }
        CHECK(e.shows[0] != e.shows[1]);
    }
    CHECK(experiments > 1);
}

TEST_CASE("an object at a different position is not reported as missing", "[diagnose]") {
    SceneDocument document;
    Scene& scene = document.scene;
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {-1, 1, 1, 0};
    scene.lights = {sun};
    Object ball = object_of(primitive(Primitive::Sphere, 48));
    ball.transform.translate = {-1.6f, 0, 0};  // its mirror image covers the scene's background
    scene.objects = {ball};
    for (std::size_t m = 0; m < mistake_names().size(); ++m) {
        if (mistake_names()[m].name != "light_in_wrong_space" && mistake_names()[m].name != "normals_flipped")
            continue;
        const Picture wrong = picture_under(scene, {m});
        if (!differ(wrong, picture_under(scene, {}))) continue;
        const Diagnosis d = diagnosed(document, turned_over(wrong, false, true));
        REQUIRE(d.verdict == Verdict::Mistake);
        CHECK(names(d.candidates.front(), {m}));
        CHECK(d.display.change.mirrored);
    }
}

TEST_CASE("each candidate is reported with the submitted picture's colour at its pixel", "[diagnose]") {
    SceneDocument document;
    Scene& scene = document.scene;
    scene.camera.eye = {0, 0, 5};
    scene.global_ambient = {0.1f, 0.3f, 0.2f};
    Light left, right;
    left.kind = right.kind = LightKind::Point;
    left.position = {-1, 1, 2, 1};
    right.position = {1, 1, 3, 1};
    right.falloff = {1, 0.3f, 0};
    scene.lights = {left, right};
    // When mirrored, the plane covers pixels where the submitted picture shows its uniform background, and
    // the mistake makes the plane uniform as well.
    Object plane = object_of(primitive(Primitive::Plane, 1));
    plane.transform.translate = {-0.9f, 0.5f, 0};
    plane.transform.rotate_deg = {90, 0, 38};
    plane.transform.scale = {0.3f, 1, 0.5f};
    plane.material.ambient = {0.2f, 0.4f, 0.3f};
    plane.material.diffuse = {0.3f, 0.6f, 0.2f};
    scene.objects = {plane};
    scene.shading.mode = ShadingMode::Gouraud;
    scene.shading.reflection = Reflection::Lambert;
    scene.display.background = {0.06f, 0.13f, 0.04f};
    scene.shading.mistakes.normals_flipped = true;
    Renderer renderer;
    const Picture wrong = renderer.render(scene, diagnosed_size);
    scene.shading.mistakes = {};
    const Diagnosis d = diagnosed(document, wrong);
    REQUIRE(d.verdict == Verdict::LeftOut);  // no light reaches the only surface
    CHECK(is_named(d, {place_of("normals_flipped")}));
    CHECK(d.display.change == DisplayChange{});
    for (const Candidate& c : d.candidates) CHECK(c.mine == rgb_at(wrong, wrong.pixel(c.pixel.x, c.pixel.y)));
}

TEST_CASE("candidates for an unexplained picture are reported with its colours", "[diagnose]") {
    // A mistake in a flipped and darkened picture would be the nearest explanation.
    const SceneDocument document = std::get<SceneDocument>(open_document(
        project_file("assets/scenes/inverse-square.json"),
        {{"/lights/-",
          R"({"type":"spot","position":[1.48627,4,2.35087],"spot":{"direction":[-0.140561,-1,0.2],"cutoff_deg":35,"exponent":3}})"},
         {"/lights/0/intensity", "1.62"},
         {"/lights/0/falloff/quadratic", "0.49"}}));
    Scene scene = document.scene;
    scene.shading.mistakes.no_normals_given = scene.shading.mistakes.falloff_inverted = true;
    Renderer renderer;
    const Picture wrong = renderer.render(scene, {320, 180});
    const Diagnosis d = diagnosed(document, wrong);
    REQUIRE(d.verdict == Verdict::NotInCatalogue);
    CHECK(d.display.change == DisplayChange{});
    CHECK(!d.candidates.empty());
    for (const Candidate& c : d.candidates) CHECK(c.mine == rgb_at(wrong, wrong.pixel(c.pixel.x, c.pixel.y)));
}

TEST_CASE("no spreadsheet takes a picture's name in a table for a formula", "[diagnose]") {
    for (const std::string name : {"=1+2.png", "+a.png", "-a.png", "@a.png"})
        CHECK(diagnoses_csv({{name, {}, {}, {}}}).find("\n./" + name + ",") != std::string::npos);
    CHECK(diagnoses_csv({{"a=1.png", {}, {}, {}}}).find("\na=1.png,") != std::string::npos);
}
