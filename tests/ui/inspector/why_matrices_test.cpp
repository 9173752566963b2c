// The matrices tab: transformed positions agree with the renderer's.
#include <glm/geometric.hpp>

#include "renderer/shade/light_sources.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/inspector.h"

using namespace glint;
using test::HeadlessWindow;

TEST_CASE("lights are transformed to the equation's positions and back to their own", "[ui][why]") {
    HeadlessWindow bench;
    Scene& scene = bench.scene();
    scene.camera = {{2, 1, 5}, {0.3f, 0.1f, 0}, {0, 1, 0}, Perspective{}};
    scene.lights[1].space = LightSpace::Camera;
    const std::vector<LightSource> sources = light_sources(scene);
    REQUIRE(sources.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const CarriedLight both = carried(scene.lights[i], scene.camera);
        glm::dvec3 camera(both.camera);
        if (both.camera.w == 0) camera = glm::normalize(camera);  // the equation's directions are normalized
        CHECK(camera.x == Approx(sources[i].xyz.x).margin(1e-5));
        CHECK(camera.y == Approx(sources[i].xyz.y).margin(1e-5));
        CHECK(camera.z == Approx(sources[i].xyz.z).margin(1e-5));
        CHECK(both.camera.w == scene.lights[i].position.w);
        const glm::dvec4 home = world_from_view(scene.camera) * both.camera;
        CHECK(glm::distance(home, both.world) < 1e-9);
    }
    // The eye is at the origin of camera coordinates.
    Light at_eye;
    at_eye.position = glm::vec4(scene.camera.eye, 1);
    CHECK(glm::length(glm::dvec3(carried(at_eye, scene.camera).camera)) < 1e-6);
}

TEST_CASE("with lights in the wrong space the tab agrees with the picture", "[ui][why]") {
    HeadlessWindow bench;
    Scene& scene = bench.scene();
    scene.camera = {{2, 1, 5}, {0.3f, 0.1f, 0}, {0, 1, 0}, Perspective{}};
    scene.lights[1].space = LightSpace::Camera;
    scene.shading.mistakes.light_in_wrong_space = true;
    const std::vector<LightSource> sources = light_sources(scene);
    REQUIRE(sources.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const CarriedLight both = carried(scene.lights[i], scene.camera, scene.shading.mistakes);
        glm::dvec3 camera(both.camera);
        if (both.camera.w == 0) camera = glm::normalize(camera);  // the equation's directions are normalized
        const glm::dvec3 lit(sources[i].xyz.x, sources[i].xyz.y, sources[i].xyz.z);
        CHECK(glm::distance(camera, lit) < 1e-5);
        CHECK(glm::distance(world_from_view(scene.camera) * both.camera, both.world) < 1e-9);
    }
}

TEST_CASE("the matrices tab edits nothing; a click on a light selects it", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Matrices);
    const Scene start = bench.scene();
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.click(test::in_column(bench, "/lights/1/position"));
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 1});
    CHECK(bench.scene() == start);
}
