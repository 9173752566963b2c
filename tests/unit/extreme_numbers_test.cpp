// Numbers as large as a scene may hold them: what they give is what the formulas say, and never no number.
#include <cmath>
#include <numbers>

#include "renderer/pipeline/light_sources.h"
#include "renderer/renderer.h"
#include "tests/catch.h"
#include "tests/unit/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize size{21, 21};

/// A white plate in z = 0 that faces +z, seen square on, under one light; the middle pixel shows the origin.
Scene plate_under(const Light& light) {
    Scene scene;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    scene.global_ambient = glm::vec3(0);
    scene.lights = {light};
    scene.objects = {object_of(primitive(Primitive::Plane, 2))};
    scene.objects[0].transform.rotate_deg.x = 90;
    scene.objects[0].material.diffuse = scene.objects[0].material.specular = glm::vec3(1);
    scene.shading.reflection = Reflection::Lambert;
    return scene;
}

Light light_at(LightKind kind, glm::vec3 place) {
    Light light;
    light.kind = kind;
    light.position = glm::vec4(place, 1);
    return light;
}

Explanation middle(const Scene& scene) {
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, size, true);
    Explanation e = renderer.explain(10, 10);
    CHECK(same_bits(e.sum, picture.linear_at(10, 10)));
    return e;
}

}  // namespace

TEST_CASE("a point light lights however far it is, and its falloff with it", "[extreme]") {
    for (const float d : {1e10f, 1e17f, 1e19f, 1e25f, 1e30f}) {
        CAPTURE(d);
        Light light = light_at(LightKind::Point, {0, 0.6f * d, 0.8f * d});  // 3, 4, 5: n.l = 0.8
        const Explanation bare = middle(plate_under(light));
        CHECK(bare.sum.x == Approx(0.8));
        CHECK(bare.at.lights[0].distance == Approx(d));
        light.falloff = {1, 3 / d, 0};
        CHECK(middle(plate_under(light)).sum.x == Approx(0.2));  // 0.8 / (1 + 3)
    }
}

TEST_CASE("a light's cone is where it is however far the light, and no exponent makes it brighter",
          "[extreme]") {
    Light light = light_at(LightKind::Spot, {1e22f, 2e22f, 3e22f});
    light.spot = {{-1, -2, -3}, 20, 0};
    CHECK(middle(plate_under(light)).sum.x == Approx(3 / std::sqrt(14.0)));
    light.spot.direction = {1, -2, -3};
    CHECK(middle(plate_under(light)).sum.x == 0);
    light.spot = {{-1, -2, -3}, 20, 1e30f};  // cos 0 is 1, rounded perhaps a little more
    CHECK(middle(plate_under(light)).at.lights[0].spot <= 1);
}

TEST_CASE("a far and large area light gives A cos theta' / (pi r^2)", "[extreme]") {
    Light light = light_at(LightKind::Area, {0, 0, 1e22f});
    light.area = {{1e20f, 0, 0}, {0, 1e20f, 0}, 64};  // A = 4e40; all of it within a degree of its middle
    CHECK(middle(plate_under(light)).sum.x == Approx(4e40 / (std::numbers::pi * 1e44)).epsilon(1e-3));
}

TEST_CASE("no numbers that a scene may hold give a picture without a number", "[extreme]") {
    Light huge_area = light_at(LightKind::Area, {0, 0, 2});
    huge_area.area = {{1e30f, 0, 0}, {0, 1e30f, 0}, 4};
    Light huge_middle = huge_area;
    huge_middle.area.samples = 9;  // one sample is near
    Light bright = light_at(LightKind::Point, {3, 0, 1});
    bright.specular = bright.diffuse = {1e30f, 0, 1e30f};
    bright.intensity = 1e15f;
    Light below = bright;
    below.position.z = -1;  // n.l < 0: nothing of all that
    Light falling = bright;
    falling.falloff = {0, 0, 1e30f};
    Light far = bright;
    far.position = {1e30f, 1e30f, 1e30f, 1};
    for (const Light& light : {huge_area, huge_middle, bright, below, falling, far})
        for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
            for (const Reflection model :
                 {Reflection::Phong, Reflection::BlinnPhong, Reflection::CookTorrance}) {
                Scene scene = plate_under(light);
                scene.shading.mode = mode;
                scene.shading.reflection = model;
                scene.objects[0].material.diffuse = {1e30f, 1, 0};
                scene.objects[0].material.specular = {0, 1e30f, 1};
                Renderer renderer(1);
                int without = 0;
                for (const float c : renderer.render(scene, size, true).linear) without += std::isnan(c);
                CAPTURE(static_cast<int>(mode), static_cast<int>(model));
                CHECK(without == 0);
            }
}
