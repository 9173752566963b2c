// Axes in the corner, the ground grid, warnings about lights, and the picture's menu.
#include <glm/geometric.hpp>

#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "ui/fields/panels.h"

using namespace glint;
using namespace glint::test;

namespace {

bool lists_control_named(const HeadlessWindow& bench, std::string_view name) {
    return std::any_of(bench.controls().begin(), bench.controls().end(),
                       [&](const NamedControl& control) { return control.name == name; });
}

void right_click(HeadlessWindow& bench, ImVec2 at) {
    bench.move(at);
    bench.button(true, 1);
    bench.button(false, 1);
    bench.frames(2);
}

}  // namespace

TEST_CASE("clicking the end of an axis turns the view to that side", "[ui][window][camera]") {
    HeadlessWindow bench;
    bench.frames(3);
    bench.click(bench.control("View from the right"));
    bench.frames(2);
    const Camera& camera = bench.scene().camera;
    const glm::vec3 way = glm::normalize(camera.eye - camera.target);
    CHECK(way.x == Approx(1).margin(1e-4));
    CHECK_FALSE(bench.state.viewport.probe);  // the click did not pick a pixel
    run_command(bench.state, command_named("Axes in the corner"));
    bench.frames(2);
    CHECK_FALSE(lists_control_named(bench, "View from the right"));
}

TEST_CASE("the ground grid is drawn over the picture without changing it", "[ui][window][camera]") {
    HeadlessWindow bench;
    bench.frames(3);
    const int before = ImGui::GetDrawData()->TotalVtxCount;
    const std::vector<std::uint8_t> picture = bench.state.displayed->rgba;
    run_command(bench.state, command_named("Ground grid"));
    bench.frames(2);
    CHECK(ImGui::GetDrawData()->TotalVtxCount > before + 500);
    CHECK(bench.state.displayed->rgba == picture);
}

TEST_CASE("a light below the ground, or behind the picked surface, is marked in the list",
          "[ui][window][lights]") {
    HeadlessWindow bench;
    bench.frames(2);
    CHECK_FALSE(lists_control_named(bench, "Light without effect"));
    bench.scene().lights[0].position = {0, -1, 0.2f, 0};
    bench.frames(3);
    REQUIRE(lists_control_named(bench, "Light without effect"));
    CHECK(bench.state.get<LightFocus>().warnings[0] == "It shines from below the ground");
    bench.scene().lights[0].position = {0, 0.1f, -1, 0};  // from behind the ball
    ask(bench, InspectorTab::Equation);
    CHECK(bench.state.get<LightFocus>().warnings[0] == "It is behind the surface at the picked pixel");
}

TEST_CASE("a right-click on the picture opens a menu; a right-drag pans", "[ui][window][picture]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Light, 1};
    std::string clipboard;
    use_clipboard(clipboard);
    bench.frames(3);
    bench.drag(bench.at_pixel({300, 300}), bench.at_pixel({340, 300}), 1);
    bench.frames(2);
    CHECK_FALSE(lists_control_named(bench, "Copy colour"));
    const ImVec2 at = bench.at_pixel({bench.state.rendered->size.width / 2.0, 350.0});
    right_click(bench, at);
    bench.click(bench.control("Copy colour"));
    bench.frames(2);
    CHECK(clipboard.size() == 7);
    CHECK(clipboard.starts_with("#"));
    right_click(bench, at);
    const Scene before = bench.scene();
    bench.click(bench.control("Brightest here: Bulb"));
    bench.frames(3);
    CHECK_FALSE(bench.scene().lights[1].position == before.lights[1].position);
    CHECK(bench.state.editor.history.undo_name() == "Move Bulb");
    right_click(bench, at);
    bench.click(bench.control("Why this colour?"));
    bench.frames(3);
    REQUIRE(bench.state.on_screen.explanation);
    const auto& lights = bench.state.on_screen.explanation->at.lights;
    CHECK(lights.at(1).n_dot_l == Approx(1).margin(1e-3));
}

TEST_CASE("F frames each object to 80 % of the picture, even on a large floor", "[ui][window][camera]") {
    for (const auto& [size, floor] :
         {std::pair(ImVec2(1024, 768), 40.0f), {ImVec2(1280, 800), 8.0f}, {ImVec2(1920, 1080), 400.0f}}) {
        HeadlessWindow bench(size);
        bench.frames(2);
        Scene& scene = bench.scene();
        scene.objects[0].transform.scale = {1, 0.3f, 0.5f};
        scene.objects.push_back(scene.objects[0]);
        scene.objects[1].transform = {.translate = {0, -1, 0}, .scale = {floor, 0.01f, floor}};
        bench.frames(2);
        for (const int object : {0, 1}) {
            bench.state.editor.selection = {Selection::Kind::Object, object};
            (void)bench.key(Key::F);
            bench.frames(3);
            scene.objects[1].visible = object == 1;  // so that it hides no part of the other
            bench.frames(3);
            const PictureSize drawn = bench.state.rendered->size;
            glm::ivec2 low(drawn.width, drawn.height), high(-1);
            for (int y = 0; y < drawn.height; ++y)
                for (int x = 0; x < drawn.width; ++x)
                    if (bench.state.renderer->object_at(x, y) == object)
                        low = glm::min(low, glm::ivec2(x, y)), high = glm::max(high, glm::ivec2(x, y));
            const double wide = double(high.x - low.x + 1) / drawn.width;
            const double tall = double(high.y - low.y + 1) / drawn.height;
            CAPTURE(object, wide, tall, drawn.width, drawn.height);
            CHECK(std::max(wide, tall) == Approx(0.8).margin(0.02));
            CHECK((low.x + high.x) / 2.0 == Approx(drawn.width / 2.0).margin(0.02 * drawn.width));
        }
    }
}
