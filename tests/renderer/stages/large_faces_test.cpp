// Polygons with very many corners: values computed once per face, not per pixel or triangle.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <random>

#include "renderer/geometry/object_normals.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize discs_size{96, 72};

MeshPtr disc(int corners, glm::vec3 centre, float tilt_deg) {
    const float tilt = glm::radians(tilt_deg);
    std::vector<glm::vec3> around;
    for (int i = 0; i < corners; ++i) {
        const float at = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(corners);
        around.push_back(
            centre + glm::vec3(std::cos(at) * std::cos(tilt), std::sin(at), std::cos(at) * std::sin(tilt)));
    }
    return std::make_shared<const Mesh>(make_polygon(std::move(around)));
}

/// Discs next to each other, so that each row of pixels crosses several; each has a single face, number 0.
Scene discs(int corners) {
    Scene scene;
    scene.camera.eye = {0, 0, 9};
    scene.lights = {Light{}};
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].position = {0.3f, 0.4f, 1, 0};
    int place = -2;
    for (const float tilt : {-60.0f, -10.0f, 30.0f})
        scene.objects.push_back(object_of(disc(corners, {2.0f * static_cast<float>(++place), 0, 0}, tilt)));
    return scene;
}

}  // namespace

TEST_CASE("neighbouring faces with many corners have their own facet normals", "[renderer][large-faces]") {
    Renderer renderer(2);
    for (const int corners : {500, 501}) {
        Scene scene = discs(corners);
        scene.shading.mode = ShadingMode::Facet;
        const Picture facet = renderer.render(scene, discs_size, true);
        // The same by a different path: the normals of the corners equal those of the face, and are
        // interpolated.
        scene.shading.mode = ShadingMode::Phong;
        for (Object& object : scene.objects) object.normals.source = NormalSource::Facet;
        const Picture& interpolated = renderer.render(scene, discs_size, true);
        for (std::size_t i = 0; i < facet.linear.size(); ++i)
            REQUIRE(facet.linear[i] == Approx(interpolated.linear[i]).margin(1e-5));
        CHECK(facet.linear_at(24, 36) != facet.linear_at(48, 36));
        CHECK(facet.linear_at(48, 36) != facet.linear_at(72, 36));
    }
}

TEST_CASE("faces with many corners are culled separately by the light", "[renderer][large-faces]") {
    Scene scene = discs(500);
    scene.shading.mistakes.culled_by_light = true;
    scene.lights[0].position = {-1, 0, 0.7f, 0};  // behind the first disc and in front of the others
    Renderer renderer(2);
    (void)renderer.render(scene, discs_size);
    CHECK(renderer.object_at(24, 36) < 0);
    CHECK(renderer.object_at(48, 36) == 1);
    CHECK(renderer.object_at(72, 36) == 2);
}

TEST_CASE("drawing a face with 200,000 corners takes time linear in corners and pixels",
          "[renderer][large-faces]") {
    // Not timed: an algorithm that visits the entire face for each pixel or triangle takes minutes here.
    Scene scene = discs(200'000);
    scene.shading.mistakes.culled_by_light = true;
    Renderer renderer(2);
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Facet}) {
        scene.shading.mode = mode;
        (void)renderer.render(scene, {640, 480});
        CHECK(renderer.object_at(320, 240) == 1);
    }
}
