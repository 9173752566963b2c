// A pixel explained for a changed scene equals the explanation of that scene.
#include <functional>

#include "models/scene/mistakes.h"
#include "renderer/explain/equation_text.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize small{96, 72};

int differing_pixels(const Renderer& drawn, const Renderer& other, const Scene& scene) {
    const int apart = sanitized ? 7 : 3;
    int wrong = 0;
    for (int y = 0; y < small.height; y += apart)
        for (int x = 0; x < small.width; x += apart)
            wrong += explain_json(drawn.explain_as(scene, x, y)) != explain_json(other.explain(x, y));
    return wrong;
}

}  // namespace

TEST_CASE("a pixel explained for another scene equals that scene's explanation bit for bit",
          "[explain][why]") {
    const Scene scene = busy_scene();
    const std::vector<std::function<void(Scene&)>> changes{
        [](Scene& s) { s.shading.mode = ShadingMode::Flat; },
        [](Scene& s) { s.shading.mode = ShadingMode::Facet; },
        [](Scene& s) { s.shading.mode = ShadingMode::Gouraud; },
        [](Scene& s) {
            s.shading.mode = ShadingMode::Gouraud;
            s.shading.interpolation = Interpolation::Scanline;
            s.shading.rules = Rules::OpenGL2;
        },
        [](Scene& s) { s.shading.reflection = Reflection::None; },
        [](Scene& s) { s.shading.mistakes.normals_flipped = true; },
        [](Scene& s) { s.objects.front().normals.source = NormalSource::Facet; },
        [](Scene& s) { s.lights.front().position.x += 0.5f; },
        [](Scene& s) { s.objects.back().material.shininess = 3; },
        [](Scene& s) { s.display.exposure = 0.5f; },
    };
    Renderer drawn(1), other(1);
    (void)drawn.render(scene, small);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Scene changed = scene;
        changes[i](changed);
        (void)other.render(changed, small);
        CAPTURE(i);
        CHECK(differing_pixels(drawn, other, changed) == 0);
    }
    CHECK(differing_pixels(drawn, drawn, scene) == 0);
}
