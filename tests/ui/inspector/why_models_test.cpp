// One pixel in all four shading modes, side by side.
#include <algorithm>
#include <glm/geometric.hpp>

#include "renderer/shade/light_sources.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/inspector.h"
#include "ui/fields/field_panel.h"

using namespace glint;
using test::HeadlessWindow;

TEST_CASE("the models tab shows the pixel's value as drawn in each shading mode", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Models, {0.42, 0.38});
    const auto all = under_each_mode(bench.state, *bench.state.on_screen.explanation);
    Renderer renderer(1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Scene scene = bench.scene();
        scene.shading.mode = static_cast<ShadingMode>(i);
        (void)renderer.render(scene, bench.state.rendered->size);
        const Explanation drawn =
            renderer.explain(bench.state.on_screen.explanation->x, bench.state.on_screen.explanation->y);
        CHECK(all[i].sum == drawn.sum);
        CHECK(all[i].byte == drawn.byte);
        CHECK(all[i].corners.size() == drawn.corners.size());
    }
    CHECK(all[2].corners.size() == 3);
    CHECK(all[0].sum != all[3].sum);
}

TEST_CASE("Gouraud's loss at a pixel is compared with Phong's own picture", "[ui][window][why]") {
    HeadlessWindow bench;
    bench.scene().shading.mode = ShadingMode::Gouraud;
    test::ask(bench, InspectorTab::Equation, {0.42, 0.38});
    const Explanation gouraud = *bench.state.on_screen.explanation;
    const auto phong = under_phong(bench.state, gouraud);
    REQUIRE(phong);
    Renderer renderer(1);
    Scene scene = bench.scene();
    scene.shading.mode = ShadingMode::Phong;
    (void)renderer.render(scene, bench.state.rendered->size);
    CHECK(phong->sum == renderer.explain(gouraud.x, gouraud.y).sum);
    Explanation other_part = gouraud;  // of a comparison, drawn by another renderer
    other_part.mode = ShadingMode::Flat;
    CHECK_FALSE(under_phong(bench.state, other_part));
}

TEST_CASE("hovering over a model previews it, a click applies it, undo reverts it", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Models);
    const Scene start = bench.scene();
    const auto values = under_each_mode(bench.state, *bench.state.on_screen.explanation);
    const ImVec2 at = test::rest_on(bench, "Gouraud");
    CHECK(bench.state.rendered_scene.shading.mode == ShadingMode::Gouraud);
    CHECK(bench.scene() == start);
    CHECK(under_each_mode(bench.state, *bench.state.on_screen.explanation)[0].sum == values[0].sum);
    bench.click(at);
    CHECK(bench.scene().shading.mode == ShadingMode::Gouraud);
    test::rest(bench);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("the models tab finds Blinn's shininess for this Phong highlight and applies it",
          "[ui][window][why]") {
    HeadlessWindow bench({1280, 1200});
    bench.scene().shading.reflection = Reflection::Phong;
    bench.scene().objects[0].material.shininess = 10;
    test::ask(bench, InspectorTab::Models);
    bench.click(test::in_column(bench, "Change to Blinn–Phong"));
    bench.frames(1);
    CHECK(bench.scene().shading.reflection == Reflection::BlinnPhong);
    CHECK(bench.scene().objects[0].material.shininess == Approx(41.3).margin(0.1));
}

TEST_CASE("the first tabs are in the bar, the others under More, which shows their name",
          "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Equation);
    for (const char* first : {"Equation", "Vectors", "Mistakes"}) (void)test::in_column(bench, first);
    const auto lists = [&](std::string_view name) {
        return std::any_of(
            bench.controls().begin(), bench.controls().end(), [&](const NamedControl& control) {
                return control.name == name && control.at.low.x > test::right_column(bench).low.x;
            });
    };
    CHECK_FALSE(lists("Plots"));
    CHECK_FALSE(lists("Shadings"));
    bench.click(test::in_column(bench, "More ▾"));
    bench.frames(2);
    bench.click_on("Sensitivity");
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::Sensitivity);
    CHECK(lists("Sensitivity ▾"));
}

// The matrices tab: transformed positions agree with the renderer's.
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

TEST_CASE("with lights in the wrong space, the matrices tab agrees with the picture", "[ui][why]") {
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

TEST_CASE("the matrices tab edits nothing, a click on a light selects it", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Matrices);
    const Scene start = bench.scene();
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.click(test::in_column(bench, "/lights/1/position"));
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 1});
    CHECK(bench.scene() == start);
}
