// The largest numbers of a scene: every term and every sum of the equation stays within a float.
#include <algorithm>
#include <cmath>

#include "models/range.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr auto largest = static_cast<float>(max_number);

/// A plate in z = 0 that faces +z, seen perpendicularly, with the largest reflectances.
Scene bright_plate() {
    Scene scene;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    scene.global_ambient = glm::vec3(largest);
    scene.objects = {object_of(primitive(Primitive::Plane, 1))};
    scene.objects[0].transform.rotate_deg.x = 90;
    Material& m = scene.objects[0].material;
    m.ambient = m.diffuse = m.specular = m.emission = m.f0 = {largest, 0, largest};
    m.shininess = 0;
    return scene;
}

/// A light whose falloff is max_factor on the plate where it faces the light.
Light bright_light(LightKind kind) {
    Light light;
    light.kind = kind;
    light.position = {0, 0, 1, 1};
    light.intensity = largest;
    light.ambient = light.diffuse = light.specular = {largest, largest, 0};
    light.falloff = {0, 0, 1e-30f};
    light.area = {{largest, 0, 0}, {0, largest, 0}, 1};
    return light;
}

/// The count of numbers in the picture that are not finite. Checks that explanations equal their pixels.
int not_finite(const Scene& scene) {
    constexpr PictureSize size{9, 9};
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, size, true);
    for (int i = 0; i < size.width; ++i)
        CHECK(same_bits(renderer.explain(i, i).sum, picture.linear_at(i, i)));
    return static_cast<int>(std::count_if(picture.linear.begin(), picture.linear.end(),
                                          [](float c) { return !std::isfinite(c); }));
}

}  // namespace

TEST_CASE("the largest numbers give finite colours under every model, mode and tone", "[renderer]") {
    for (const LightKind kind : {LightKind::Point, LightKind::Spot, LightKind::Area})
        for (const Reflection model : {Reflection::Phong, Reflection::OrenNayar, Reflection::CookTorrance})
            for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
                for (const bool other : {false, true}) {
                    Scene scene = bright_plate();
                    scene.lights = {bright_light(kind), bright_light(kind)};
                    scene.shading.reflection = model;
                    scene.shading.mode = mode;
                    scene.npr.cool_to_warm = other;
                    scene.npr.alpha = -largest, scene.npr.beta = largest;
                    scene.shading.mistakes.unnormalized_light = other;
                    CAPTURE(static_cast<int>(kind), static_cast<int>(model), static_cast<int>(mode), other);
                    CHECK(not_finite(scene) == 0);
                }
}

TEST_CASE("the sum of 4096 lights of the largest numbers is finite", "[renderer]") {
    Scene scene = bright_plate();
    scene.lights.assign(max_lights, bright_light(LightKind::Area));
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, {1, 1}, true);
    CHECK(picture.linear[0] > 1e35f);
    CHECK(std::isfinite(picture.linear[0]));
}

TEST_CASE("a mesh of the largest coordinates, enlarged and far away, gives a finite picture", "[renderer]") {
    for (const bool perspective : {true, false})
        for (const float offset : {0.0f, largest}) {
            Scene scene = bright_plate();
            if (perspective) scene.camera.projection = Perspective{90, 0.1f, largest};
            Mesh mesh = make_primitive(Primitive::Plane, 3);
            for (glm::vec3& p : mesh.positions) p *= largest;
            scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
            scene.objects[0].transform.scale = glm::vec3(largest);
            scene.objects[0].transform.translate.x = offset;
            scene.lights = {bright_light(LightKind::Point)};
            scene.lights[0].position = {largest, largest, largest, 1};
            scene.lights[0].falloff = {largest, largest, largest};
            CHECK(not_finite(scene) == 0);
        }
}
