// Tests cool-to-warm shading against its closed form and in pictures. Lecture: "Non-photorealistic shading".
#include <cmath>

#include "renderer/lighting/reflection.h"
#include "renderer/renderer.h"
#include "tests/support/as_fresh.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize tone_size{64, 48};

/// Typical numbers of Gooch et al. 1998: b = .4, y = .4, alpha = .2, beta = .6.
CoolToWarm typical_tone(Float3 light) {
    CoolToWarm tone;
    tone.on = true;
    tone.cool = {0, 0, 0.4f};
    tone.warm = {0.4f, 0.4f, 0};
    tone.alpha = 0.2f;
    tone.beta = 0.6f;
    tone.light = light;
    return tone;
}

/// A quad that fills the picture of an orthographic camera; n = v = (0, 0, 1).
Scene facing_quad() {
    Scene scene;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    scene.objects = {
        object_of(polygon_mesh({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, {{0, 1, 2, 3}}))};
    scene.objects[0].material.diffuse = {0.8f, 0.3f, 0.3f};
    scene.npr.cool_to_warm = true;
    return scene;
}

Light from(glm::vec4 position, LightKind kind = LightKind::Directional) {
    Light light;
    light.kind = kind;
    light.position = position;
    light.specular = {0, 0, 0};
    return light;
}

glm::vec3 middle_of_sphere(const Scene& scene) {
    Renderer renderer(1);
    return renderer.render(scene, {33, 33}, true).linear_at(16, 16);
}

void check_near(glm::vec3 a, glm::vec3 b) {
    for (int i = 0; i < 3; ++i) CHECK(a[i] == Approx(b[i]).margin(1e-6));
}

}  // namespace

TEST_CASE("cool-to-warm at 120, 90 and 60 degrees from the light, worked out by hand", "[npr]") {
    // k_d = (.8, .3, .3): cool + alpha k_d = (.16, .06, .46), warm + beta k_d = (.88, .58, .18).
    const float sine = std::sqrt(0.75f);
    const auto color = [](Float3 light) {
        const auto t =
            cool_to_warm<float>(typical_tone(light), {0.8f, 0.3f, 0.3f}, {{}, {0, 0, 1}, {0, 0, 1}});
        return glm::vec3(t.color.x, t.color.y, t.color.z);
    };
    check_near(color({sine, 0, -0.5f}), {0.34f, 0.19f, 0.39f});
    check_near(color({1, 0, 0}), {0.52f, 0.32f, 0.32f});
    check_near(color({0, sine, 0.5f}), {0.7f, 0.45f, 0.25f});
    check_near(color({0, 0, 1}), {0.88f, 0.58f, 0.18f});
    check_near(color({0, 0, -1}), {0.16f, 0.06f, 0.46f});
}

TEST_CASE("without a direction to the light the tone is halfway between cool and warm", "[npr]") {
    CoolToWarm tone = typical_tone({1, 2, 3});
    tone.light_w = 1;
    const auto share = [&tone](PointAt<float> at) { return cool_to_warm<float>(tone, {}, at).k_w; };
    CHECK(share({{1, 2, 3}, {0, 0, 1}, {0, 0, 1}}) == 0.5f);  // the light at the point
    CHECK(share({{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}) == 0.5f);  // no normal
    Scene scene = facing_quad();
    scene.lights = {from({0, 0, 1, 0})};
    scene.lights[0].enabled = false;
    // (.3, .3, 0) + .5 k_d = (.7, .45, .15); (0, 0, .55) + .25 k_d = (.2, .075, .625); the mean of the two.
    check_near(middle_of_sphere(scene), {0.45f, 0.2625f, 0.3875f});
}

TEST_CASE("the tone replaces emission, ambient and diffuse for any colour of light", "[npr]") {
    Scene scene = facing_quad();
    Light& light =
        scene.lights.emplace_back(from({0, std::sqrt(3.0f), 1, 1}, LightKind::Point));  // n.l = 1/2
    light.falloff = {1, 1, 1};
    light.ambient = light.diffuse = {0.1f, 9, 3};
    light.intensity = 7;
    scene.global_ambient = {1, 1, 1};
    scene.objects[0].material.emission = {1, 2, 3};
    // 3/4 (.7, .45, .15) + 1/4 (.2, .075, .625)
    const glm::vec3 expected{0.575f, 0.35625f, 0.26875f};
    check_near(middle_of_sphere(scene), expected);
    light.kind = LightKind::Spot;
    light.spot = {{0, 1, 0}, 10, 1};  // the cone points away
    check_near(middle_of_sphere(scene), expected);
    light.kind = LightKind::Area;  // its centre is used
    light.area = {{3, 0, 0}, {0, 0, 0.5f}, 9};
    check_near(middle_of_sphere(scene), expected);
    light.enabled = false;
    scene.lights.push_back(from({0, 0, 1, 0}));  // the first enabled light is used
    scene.lights.push_back(from({0, 0, -1, 0}));
    check_near(middle_of_sphere(scene), {0.7f, 0.45f, 0.15f});
}

TEST_CASE("highlights of all lights are added to the tone", "[npr]") {
    Scene scene = facing_quad();
    scene.lights = {from({0, 0, 1, 0}), from({0, 0, 2, 0})};
    scene.lights[0].specular = {0.25f, 0, 0};
    scene.lights[1].specular = {0, 0.5f, 0};
    check_near(middle_of_sphere(scene), {0.95f, 0.95f, 0.15f});
    scene.shading.terms.specular = false;
    check_near(middle_of_sphere(scene), {0.7f, 0.45f, 0.15f});
}

TEST_CASE("cool-to-warm explanations sum to their pixels, and their steps give the tone", "[npr][explain]") {
    Scene scene = busy_scene();
    scene.npr.cool_to_warm = true;
    Renderer renderer(2);
    for (const ShadingMode mode :
         {ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud, ShadingMode::Phong})
        for (const Reflection model : {Reflection::None, Reflection::Phong, Reflection::CookTorrance}) {
            scene.shading.mode = mode;
            scene.shading.reflection = model;
            const Picture& picture = renderer.render(scene, tone_size, true);
            int wrong = 0;
            for (int y = 0; y < tone_size.height; ++y)
                for (int x = 0; x < tone_size.width; ++x) {
                    const Explanation e = renderer.explain(x, y);
                    const glm::vec3 pixel = picture.linear_at(x, y);
                    wrong += e.sum != pixel;
                    if (!e.hit || e.lit_per_corner) continue;
                    const ExplainedTone& t = e.at.cool_to_warm;
                    glm::vec3 sum = t.color;
                    for (const ExplainedLight& l : e.at.lights) sum += l.ambient + l.diffuse + l.specular;
                    check_near(sum, e.sum);
                    check_near(t.color, t.k_w * t.warm + (1 - t.k_w) * t.cool);
                    CHECK(t.k_w == Approx((1 + t.n_dot_l) / 2));
                }
            CHECK(wrong == 0);
        }
}

TEST_CASE("changing the tone reruns only the lighting stage", "[npr][stages]") {
    Scene scene = busy_scene();
    Renderer renderer(2);
    const auto redone = [&] {
        draw_as_fresh(renderer, scene, tone_size);
        const auto& r = renderer.stats().redone;
        return std::array<bool, 4>{r[0], r[1], r[2], r[4]};
    };
    const std::array<bool, 4> lighting{false, false, false, true}, nothing{};
    redone();
    scene.npr.cool_to_warm = true;
    CHECK(redone() == lighting);
    CHECK(redone() == nothing);
    scene.npr.warm.x = 0.9f;
    CHECK(redone() == lighting);
    scene.npr.beta = 0.1f;
    CHECK(redone() == lighting);
}
