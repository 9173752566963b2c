// Views of the scene: views by key, saved views, scrolling, and the outside view.
#include <glm/geometric.hpp>

#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "ui/commands/command.h"
#include "ui/features/inspector/outside_view.h"
#include "ui/fields/panels.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/orbit.h"

using namespace glint;
using test::HeadlessWindow;
using namespace glint::test;

namespace {

glm::vec3 looks_along(const Camera& camera) { return glm::normalize(camera.target - camera.eye); }

/// The width, in pixels, of something one unit wide at the target.
double width_at_target(const Camera& camera) {
    const ScreenMap map = screen_map(camera, {800, 600});
    const glm::dvec3 right(map.world_from_view[0]);
    return project(map, glm::dvec3(camera.target) + right).pixel.x - project(map, camera.target).pixel.x;
}

void scroll(HeadlessWindow& bench, float across, float down) {
    ImGui::GetIO().MouseWheelH = across;
    ImGui::GetIO().MouseWheel = down;
    bench.frames(2);
}

}  // namespace

TEST_CASE("the number pad shows six sides from the same distance, each as one view step",
          "[ui][hands][window]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    const struct {
        Key key;
        bool ctrl;
        glm::vec3 along;
    } views[] = {{Key::Pad1, false, {0, 0, -1}}, {Key::Pad1, true, {0, 0, 1}},
                 {Key::Pad3, false, {-1, 0, 0}}, {Key::Pad3, true, {1, 0, 0}},
                 {Key::Pad7, false, {0, -1, 0}}, {Key::Pad7, true, {0, 1, 0}}};
    for (const auto& view : views) {
        bench.key(view.key, view.ctrl);
        CHECK(glm::dot(looks_along(bench.scene().camera), view.along) > 0.99999f);
        CHECK(target_depth(bench.scene().camera) == Approx(target_depth(before.camera)));
        bench.frames(1);
        run_command(bench.state, test::command_named("Previous view"));
        CHECK(bench.scene().camera == before.camera);
        run_command(bench.state, test::command_named("Next view"));
        CHECK(glm::dot(looks_along(bench.scene().camera), view.along) > 0.99999f);
        run_command(bench.state, test::command_named("Previous view"));
        bench.frames(1);
    }
    bench.key(Key::Pad0);
    CHECK(bench.scene().camera == before.camera);
}

TEST_CASE("a view from any side shows the scene's full depth", "[ui][hands][window]") {
    const auto [key, ctrl] = GENERATE(table<Key, bool>({{Key::Pad1, false},
                                                        {Key::Pad1, true},
                                                        {Key::Pad3, false},
                                                        {Key::Pad3, true},
                                                        {Key::Pad7, false},
                                                        {Key::Pad7, true}}));
    HeadlessWindow bench;
    bench.scene().camera.eye = {0, 0, 8};
    bench.scene().camera.projection = Perspective{45, 7, 9.5f};
    bench.scene().objects[0].transform.scale = {3, 2, 0.5f};
    bench.frames(2);
    bench.key(key, ctrl);
    const Camera& camera = bench.scene().camera;
    const ScreenMap map = screen_map(camera, {64, 64});
    for (const glm::dvec3& corner : corners_of(scene_bounds(bench.scene()))) {
        CHECK(project(map, corner).depth > double(near_of(camera.projection)));
        CHECK(project(map, corner).depth < double(far_of(camera.projection)));
    }
}

TEST_CASE("number pad 5 toggles parallel projection and keeps the target's size", "[ui][hands][window]") {
    DrawnWindow bench;
    const Camera before = bench.scene().camera;
    bench.key(Key::Pad5);
    CHECK(is_orthographic(bench.scene().camera.projection));
    CHECK(width_at_target(bench.scene().camera) == Approx(width_at_target(before)));
    bench.key(Key::Pad5);
    CHECK_FALSE(is_orthographic(bench.scene().camera.projection));
    CHECK(width_at_target(bench.scene().camera) == Approx(width_at_target(before)));
}

TEST_CASE("at most eight views are saved, and a command cycles through them", "[ui][hands]") {
    std::vector<Camera> views;
    CHECK_FALSE(next_view(views, Camera{}));
    for (int i = 0; i < 9; ++i) {
        Camera camera;
        camera.eye.x = float(i);
        keep_view(views, camera);
        keep_view(views, camera);
    }
    REQUIRE(views.size() == max_views);
    CHECK(views.front().eye.x == 1);
    CHECK(next_view(views, views[2])->eye.x == 4);
    CHECK(next_view(views, views.back()) == views.front());
    CHECK(next_view(views, Camera{}) == views.front());
}

TEST_CASE("a key returns to a saved view as one step", "[ui][hands][window]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    CHECK_FALSE(why_disabled(bench.state, command(CommandId::NextView)).empty());
    bench.key(Key::U, false, true);
    // The view is saved with the settings and outlives the window.
    CHECK(bench.state.notifications.list.back().text == "View kept: U returns to it");
    bench.drag(bench.at_pixel({40, 400}), bench.at_pixel({240, 340}));
    CHECK_FALSE(bench.scene().camera == before.camera);
    bench.key(Key::U);
    CHECK(bench.scene() == before);
}

TEST_CASE("two-finger scrolling pans with Shift or sideways, turns with Alt, or else zooms",
          "[ui][hands][window]") {
    DrawnWindow bench;
    const Camera start = bench.scene().camera;
    bench.move(bench.at_pixel({300, 300}));
    scroll(bench, 1.5f, 0);
    const Camera panned = bench.scene().camera;
    CHECK(glm::length((panned.eye - panned.target) - (start.eye - start.target)) < 1e-4f);
    CHECK_FALSE(panned.target == start.target);
    ImGui::GetIO().KeyShift = true;
    scroll(bench, 0, 2);
    ImGui::GetIO().KeyShift = false;
    CHECK(glm::length((bench.scene().camera.eye - bench.scene().camera.target) - (start.eye - start.target)) <
          1e-4f);
    CHECK_FALSE(bench.scene().camera == panned);
    const Camera before_turn = bench.scene().camera;
    ImGui::GetIO().KeyAlt = true;
    scroll(bench, 1, 1);
    ImGui::GetIO().KeyAlt = false;
    CHECK(bench.scene().camera.target == before_turn.target);
    CHECK(target_depth(bench.scene().camera) == Approx(target_depth(before_turn)));
    CHECK_FALSE(bench.scene().camera == before_turn);
    const double away = target_depth(bench.scene().camera);
    scroll(bench, 0, 1);
    CHECK(target_depth(bench.scene().camera) < away);
}

TEST_CASE("F frames the selected object, or everything if nothing is selected", "[ui][hands][window]") {
    DrawnWindow bench;
    Object small = bench.scene().objects[0];
    small.transform.translate = {4, 1, 0};
    small.transform.scale = glm::vec3(0.3f);
    bench.scene().objects.push_back(small);
    bench.frames(2);
    bench.state.editor.selection = {Selection::Kind::Object, 1};
    bench.key(Key::F);
    CHECK(glm::length(bench.scene().camera.target - small.transform.translate) < 0.05f);
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.key(Key::F);
    CHECK(bench.scene().camera.target.x < 3);
}

TEST_CASE("the outside view contains the eye, its view volume, all axes and every light", "[ui][hands]") {
    Scene scene = first_scene().scene;
    REQUIRE(problem_of(load_meshes(scene, "", "")) == nullptr);
    Selection selection;
    for (const LightKind kind : {LightKind::Directional, LightKind::Spot, LightKind::Area})
        add_light(scene, selection, kind);
    for (const glm::vec3 eye :
         {glm::vec3(0, 0, 5), glm::vec3(4, 9, -1), glm::vec3(0.01f, 7, 0), glm::vec3(0.4f, 0, 0)}) {
        scene.camera.eye = eye;
        PictureView main;
        main.map = screen_map(scene.camera, {900, 600});
        main.bounds = scene_bounds(scene);
        main.dome = sun_dome(scene.camera.target, main.bounds, main.map);
        for (const PictureSize size : {PictureSize{320, 320}, PictureSize{320, 500}, PictureSize{500, 200}}) {
            const ScreenMap map = screen_map(outside_camera(scene, main, size), size);
            const auto in_sight = [&](glm::dvec3 place) {
                const ProjectedPoint at = project(map, place);
                return at.in_front && at.pixel.x > 0 && at.pixel.y > 0 && at.pixel.x < size.width &&
                       at.pixel.y < size.height;
            };
            CHECK(in_sight(scene.camera.eye));
            CHECK(in_sight(scene.camera.target));
            for (const Light& light : scene.lights) CHECK(in_sight(handle_of(light, main.dome, main.map)));
            for (const glm::dvec2 corner : {glm::dvec2(0, 0), {900, 0}, {900, 600}, {0, 600}})
                CHECK(in_sight(unproject(main.map, corner, drawn_depth(scene.camera))));
            for (int axis = 0; axis < 3; ++axis) {
                const double length = axis_length(scene.camera);
                CHECK(in_sight(glm::dvec3(scene.camera.eye) +
                               length * glm::dvec3(world_from_view(scene.camera)[axis])));
                CHECK(in_sight(glm::dvec3(length * double(axis == 0), length * double(axis == 1),
                                          length * double(axis == 2))));
            }
        }
    }
}

TEST_CASE("a drag in the outside view turns only that view, a click selects a light", "[ui][hands][window]") {
    HeadlessWindow bench;
    bench.state.get<InspectorState>().tab = InspectorTab::Outside;
    bench.frames(3);
    REQUIRE(bench.state.get<OutsideState>().placed);
    const Scene before = bench.scene();
    const ImVec2 right = lay_out({1280, 800}, bench.state.layout, 1).right.low;
    const ImVec2 from{right.x + 170, right.y + 200};
    const Camera start = bench.state.get<OutsideState>().camera;
    bench.drag(from, {from.x + 60, from.y - 20});
    CHECK_FALSE(bench.state.get<OutsideState>().camera == start);
    CHECK(bench.state.get<OutsideState>().camera.target == start.target);
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.editor.history.can_undo());
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    REQUIRE(bench.scene().lights[1].kind == LightKind::Point);
    const Rect view = bench.area_of("Outside view");
    const ScreenMap map =
        screen_map(bench.state.get<OutsideState>().camera, {int(view.size().x), int(view.size().y)});
    const glm::dvec2 bulb = project(map, glm::dvec3(bench.scene().lights[1].position)).pixel;
    bench.click({view.low.x + float(bulb.x), view.low.y + float(bulb.y)});
    CHECK(selected_light(bench.state.editor.selection) == 1);
    CHECK(bench.scene() == before);
}

// Axes in the corner, the ground grid, warnings about lights, and the picture's menu.
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
    bench.click_on("View from the right");
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
    DrawnWindow bench;
    CHECK_FALSE(lists_control_named(bench, "Light without effect"));
    bench.scene().lights[0].position = {0, -1, 0.2f, 0};
    bench.frames(3);
    REQUIRE(lists_control_named(bench, "Light without effect"));
    CHECK(bench.state.get<LightFocus>().warnings[0] == "This light shines from below the ground");
    bench.scene().lights[0].position = {0, 0.1f, -1, 0};  // from behind the ball
    ask(bench, InspectorTab::Equation);
    CHECK(bench.state.get<LightFocus>().warnings[0] ==
          "This light is behind the surface at the picked pixel");
}

TEST_CASE("a right-click on the picture opens a menu, a right-drag pans", "[ui][window][picture]") {
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
    bench.click_on("Copy colour");
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
        DrawnWindow bench(size);
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
