// The sum of all lights except the dragged one is kept between frames: this must not change a single bit.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/as_fresh.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

constexpr PictureSize sum_size{160, 90};

Scene eight_lights() {
    const std::string path = project_file("tests/bench/knot.json");
    const Result<SceneDocument> opened = open_document(path, {{"/objects/0/mesh/detail", "60"}});
    return std::get<SceneDocument>(opened).scene;
}

/// Draws each step with a renderer that reuses results, and with a new one.
void check_same_bytes(Scene scene, const std::vector<std::function<void(Scene&)>>& steps) {
    Renderer keeping(2);
    for (const auto& step : steps) {
        step(scene);
        test::draw_as_fresh(keeping, scene, sum_size, true);
    }
}

}  // namespace

TEST_CASE("kept sums stay exact while a light circles the object", "[renderer]") {
    std::vector<std::function<void(Scene&)>> steps{[](Scene&) {}};
    for (std::size_t light = 0; light < 8; ++light)
        for (int step = 0; step < 6; ++step)
            steps.emplace_back([light](Scene& s) {  // a sixth of a turn about y
                const glm::vec4 p = s.lights[light].position;
                s.lights[light].position = {0.5f * p.x + 0.8660254f * p.z, p.y, 0.5f * p.z - 0.8660254f * p.x,
                                            p.w};
            });
    steps.emplace_back([](Scene& s) { s.display.background = {0.3f, 0, 0}, s.lights[7].position.x += 1; });
    steps.emplace_back([](Scene& s) { s.lights[7].ambient = glm::vec3(0.2f); });
    check_same_bytes(eight_lights(), steps);
    Scene drawn_over = eight_lights();
    drawn_over.npr.silhouettes = true;
    check_same_bytes(drawn_over, steps);
}

TEST_CASE("any change to a material relights only that material's pixels", "[renderer]") {
    Scene scene = eight_lights();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.translate = {0.5f, 0.2f, 0.3f};
    const auto redden = [](std::size_t object, float red) {
        return [object, red](Scene& s) { s.objects[object].material.diffuse.x = red; };
    };
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        check_same_bytes(scene, {[](Scene&) {}, redden(0, 0.1f), redden(1, 0.2f), redden(0, 0.3f),
                                 [&](Scene& s) { redden(1, 0.4f)(s), s.display.exposure = 2; },
                                 [&](Scene& s) { redden(0, 0.5f)(s), s.lights[0].position.x += 1; },
                                 [&](Scene& s) { redden(1, 0.6f)(s), s.camera.eye.x += 0.1f; },
                                 [&](Scene& s) { redden(0, 0.7f)(s), s.global_ambient = glm::vec3(0.3f); },
                                 [](Scene& s) { s.lights[3].intensity = 1e7f; },
                                 redden(1, 1e7f)});  // the largest value in a scene file
    }
}

TEST_CASE("an explanation with kept sums equals its pixel bit for bit", "[renderer][explain]") {
    Scene scene = eight_lights();
    Renderer renderer(1);
    for (int frame = 0; frame < 3; ++frame) {
        scene.lights[1].position.x += 0.2f;
        const Picture& picture = renderer.render(scene, sum_size, true);
        for (int y = 0; y < sum_size.height; y += 7)
            for (int x = 0; x < sum_size.width; x += 7) {
                const Explanation e = renderer.explain(x, y);
                const std::size_t at = 3 * picture.pixel(x, y);
                CHECK(e.sum == glm::vec3(picture.linear[at], picture.linear[at + 1], picture.linear[at + 2]));
            }
    }
}

TEST_CASE("with too few lights or an unbounded light, no sum is kept and no bit changes", "[renderer]") {
    Scene near = eight_lights();
    near.lights[2].falloff = {0, 0, 1};  // the falloff is unbounded near the light
    Scene few = eight_lights();
    few.lights.resize(2);
    for (const Scene& scene : {near, few}) {
        const auto move = [](Scene& s) { s.lights[1].position.x += 0.3f; };
        check_same_bytes(scene, {move, move, move});
    }
}

TEST_CASE("a picture with many lights, one very strong, is the sum of single-light pictures", "[renderer]") {
    for (const auto& [constant, intensity] :
         {std::pair{1e-8f, 1.0f}, {1e-4f, 1.0f}, {1.0f, 1e6f}, {1.0f, 1.0f}}) {
        Scene scene = eight_lights();
        scene.shading.reflection = Reflection::Phong;
        for (Light& light : scene.lights) light.intensity *= 0.2f;
        Light& strong = scene.lights[2];
        strong.position = glm::vec4(glm::vec3(strong.position) * std::sqrt(intensity), 1);
        strong.falloff = {constant, 0, 1};
        strong.intensity = intensity;
        INFO("constant " << constant << ", intensity " << intensity);

        Renderer renderer(1);
        const std::vector<float> all = renderer.render(scene, sum_size, true).linear;
        std::vector<double> sum(all.size());
        const auto add = [&](double factor) {
            const std::vector<float> part = renderer.render(scene, sum_size, true).linear;
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * double(part[i]);
        };
        for (Light& light : scene.lights) light.enabled = false;
        add(1 - double(scene.lights.size()));  // each picture includes the unlit part once
        for (Light& light : scene.lights) {
            light.enabled = true;
            add(1);
            light.enabled = false;
        }
        double worst = 0;
        for (std::size_t i = 0; i < sum.size(); ++i)
            worst = std::max(worst, std::abs(double(all[i]) - sum[i]));
        CHECK(worst < 1e-4);
    }
}
