// Colours, falloffs and exposures whose product no float holds: what a picture, a file and an explanation say
// of them are numbers all the same.
#include <cmath>
#include <cstring>
#include <limits>

#include "renderer/image/image_file.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize few_pixels{9, 9};

/// A white plate in z = 0 that faces +z, seen square on from z = 5.
Scene lit_plate() {
    Scene scene;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    scene.global_ambient = glm::vec3(0);
    scene.objects = {object_of(primitive(Primitive::Plane, 1))};
    scene.objects[0].transform.rotate_deg.x = 90;
    scene.objects[0].material.diffuse = scene.objects[0].material.specular = glm::vec3(1);
    scene.objects[0].material.shininess = 0;
    return scene;
}

/// A point light one unit in front of the plate's middle.
Light near_bulb(float intensity, Falloff falloff) {
    Light light;
    light.position = {0, 0, 1, 1};
    light.intensity = intensity;
    light.falloff = falloff;
    return light;
}

/// Draws, and counts the pixels' numbers that are infinite or none, each of which its explanation must have
/// too.
int not_finite(const Scene& scene) {
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, few_pixels, true);
    int count = 0;
    for (int i = 0; i < few_pixels.width; ++i) {
        const glm::vec3 sum = renderer.explain(i, i).sum;
        CHECK(same_bits(sum, picture.linear_at(i, i)));
        for (int c = 0; c < 3; ++c) count += !std::isfinite(sum[c]);
    }
    for (const float c : picture.linear) count += !std::isfinite(c);
    return count;
}

std::vector<float> numbers_of_pfm(const std::string& bytes) {
    std::vector<float> numbers(std::size_t{3} * few_pixels.width * few_pixels.height);
    std::memcpy(numbers.data(), &bytes[bytes.size() - 4 * numbers.size()], 4 * numbers.size());
    return numbers;
}

}  // namespace

TEST_CASE("a falloff that no float holds times the intensity leaves the term at 1e31", "[extreme]") {
    Scene scene = lit_plate();
    scene.shading.reflection = Reflection::Lambert;
    for (const float intensity : {1e10f, 1e15f, 1e30f}) {
        scene.lights = {near_bulb(intensity, {1e-30f, 0, 0})};
        CAPTURE(intensity);
        CHECK(not_finite(scene) == 0);
        Renderer renderer(1);
        (void)renderer.render(scene, few_pixels);
        const Explanation e = renderer.explain(4, 4);
        CHECK(e.sum.x == Approx(1e31));  // n.l is 1
        CHECK(e.at.lights[0].diffuse.x == Approx(1e31));
        CHECK(double(e.at.lights[0].falloff) * double(intensity) == Approx(1e31));
    }
    scene.lights = {near_bulb(1e10f, {1e-15f, 0, 0})};  // 1e25 is far from the end
    Renderer renderer(1);
    (void)renderer.render(scene, few_pixels);
    CHECK(renderer.explain(4, 4).sum.x == Approx(1e25));
}

TEST_CASE("every model, mode and mistake of the equation stays finite under lights without bound",
          "[extreme]") {
    Light near = near_bulb(1e20f, {0, 0, 1e-30f});
    near.ambient = {1, 0, 1e10f};
    Light area = near_bulb(1e30f, {});
    area.kind = LightKind::Area;
    area.position.z = 1e-10f;
    area.area.samples = 1;
    for (const Light& light : {near_bulb(1e10f, {1e-30f, 0, 0}), near, area})
        for (const Reflection model : {Reflection::Phong, Reflection::OrenNayar, Reflection::CookTorrance})
            for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
                for (const bool mistaken : {false, true}) {
                    Scene scene = lit_plate();
                    scene.lights = {light, light};
                    scene.shading.reflection = model;
                    scene.shading.mode = mode;
                    scene.shading.mistakes.unnormalized_light = mistaken;
                    scene.shading.mistakes.ambient_per_light_added_twice = mistaken;
                    scene.objects[0].material.diffuse = {1e30f, 1, 0};
                    scene.objects[0].material.f0 = glm::vec3(1e30f);
                    CAPTURE(static_cast<int>(model), static_cast<int>(mode), mistaken);
                    CHECK(not_finite(scene) == 0);
                }
}

TEST_CASE("the most lights there may be, each as bright as it may be, have a sum", "[extreme]") {
    Scene scene = lit_plate();
    Light light = near_bulb(1e30f, {});
    light.kind = LightKind::Area;
    light.area = {{0.5f, 0, 0}, {0, 0.5f, 0}, 1};
    light.position.z = 1e-3f;
    light.ambient = glm::vec3(1);
    scene.objects[0].material.ambient = glm::vec3(1);
    scene.lights.assign(max_lights, light);
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, {1, 1}, true);
    CHECK(std::isfinite(picture.linear[0]));
    CHECK(picture.linear[0] ==
          Approx(3 * 4096 * 1e31).epsilon(1e-3));  // each of the three terms is at its most
}

TEST_CASE("an exposure that no float holds times the light is the largest float in a linear file",
          "[extreme]") {
    Scene scene = lit_plate();
    scene.lights = {near_bulb(1e20f, {})};
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, few_pixels, true);
    for (const float number : numbers_of_pfm(pfm_bytes(picture, 1e30f)))
        if (number > 1e35f) CHECK(number == std::numeric_limits<float>::max());
    const auto plain = numbers_of_pfm(pfm_bytes(picture, 0.5f));
    CHECK(plain[3 * 40] == 0.5f * picture.linear[3 * 40]);  // the middle one of 81 rows upwards and downwards
}
