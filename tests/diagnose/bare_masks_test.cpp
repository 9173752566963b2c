// Masks of the surfaces that a mistake removes, and how those pixels are compared.
#include <algorithm>

#include "diagnose/diagnose.h"
#include "diagnose/search/probes.h"
#include "diagnose/search/score.h"
#include "models/scene/mistakes.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

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
