// The sum of all lights but the one that is dragged, kept from frame to frame: it may not change a bit.
#include <functional>

#include "models/scene_file.h"
#include "renderer/renderer.h"
#include "tests/catch.h"

using namespace glint;

namespace {

constexpr PictureSize size{160, 90};

Scene eight_lights() {
    const std::string path = std::string(GLINT_SOURCE_DIR) + "/tests/bench/knot.json";
    const Result<SceneDocument> opened = open_document(path, {{"/objects/0/mesh/detail", "60"}});
    return std::get<SceneDocument>(opened).scene;
}

/// Draws each step by a renderer that keeps sums and by one that lights every light again.
void check_same_bytes(Scene scene, const std::vector<std::function<void(Scene&)>>& steps) {
    Renderer keeping(2), relighting(1);
    relighting.keep_sums(false);
    for (const auto& step : steps) {
        step(scene);
        const Picture& kept = keeping.render(scene, size, true);
        const Picture& again = relighting.render(scene, size, true);
        CHECK(kept.rgba == again.rgba);
        CHECK(kept.linear == again.linear);
    }
}

}  // namespace

TEST_CASE("dragging a light over kept sums gives the bytes of lighting every light again", "[renderer]") {
    for (const Reflection model : {Reflection::Lambert, Reflection::Phong, Reflection::BlinnPhong,
                                   Reflection::Retro, Reflection::OrenNayar}) {
        Scene scene = eight_lights();
        scene.shading.reflection = model;
        const auto move = [](std::size_t i) {
            return [i](Scene& s) { s.lights[i].position += glm::vec4(0.3f, -0.2f, 0.1f, 0); };
        };
        check_same_bytes(
            scene,
            {[](Scene&) {}, move(0), move(0), move(0), move(7), move(7), move(5),
             [](Scene& s) { s.lights[5].intensity = 30; }, [](Scene& s) { s.lights[5].enabled = false; },
             [](Scene& s) { s.lights[5].enabled = true; }, [](Scene& s) { s.display.exposure = 2; }, move(5),
             [](Scene& s) { s.objects[0].material.diffuse.x = 0.1f; }, move(5),
             [](Scene& s) { s.camera.eye.x += 0.1f; }, move(5), move(5)});
    }
}

TEST_CASE("an explanation over kept sums equals its pixel to the last bit", "[renderer][explain]") {
    Scene scene = eight_lights();
    Renderer renderer(1);
    for (int frame = 0; frame < 3; ++frame) {
        scene.lights[1].position.x += 0.2f;
        const Picture& picture = renderer.render(scene, size, true);
        for (int y = 0; y < size.height; y += 7)
            for (int x = 0; x < size.width; x += 7) {
                const Explanation e = renderer.explain(x, y);
                const std::size_t at = 3 * picture.pixel(x, y);
                CHECK(e.sum == glm::vec3(picture.linear[at], picture.linear[at + 1], picture.linear[at + 2]));
            }
    }
}

TEST_CASE("lights without a bound, or too few of them, keep no sum and change no bit", "[renderer]") {
    Scene near = eight_lights();
    near.lights[2].falloff = {0, 0, 1};  // grows without end near the light
    Scene few = eight_lights();
    few.lights.resize(2);
    for (const Scene& scene : {near, few}) {
        const auto move = [](Scene& s) { s.lights[1].position.x += 0.3f; };
        check_same_bytes(scene, {move, move, move});
    }
}
