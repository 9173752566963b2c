// The tab "Program": numbers that are dragged where they stand, and a light's place dragged past gluLookAt.
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"

using namespace glint;
using test::HeadlessWindow;

TEST_CASE("a number of a call is dragged where it stands, one step to undo", "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Program);
    const Scene start = bench.scene();
    const ImVec2 field = test::in_column(bench, "/camera/projection/fov_y_deg");
    bench.drag(field, {field.x + 40, field.y});
    CHECK(std::get<Perspective>(bench.scene().camera.projection).fov_y_deg >
          std::get<Perspective>(start.camera.projection).fov_y_deg);
    const ImVec2 x = test::in_column(bench, "/lights/0/position/0");
    bench.drag(x, {x.x + 40, x.y});
    CHECK(bench.scene().lights[0].position.x != start.lights[0].position.x);
    bench.key(Key::Z, true);
    CHECK(bench.scene().lights[0].position == start.lights[0].position);
}

TEST_CASE("a light's place dragged past gluLookAt keeps its numbers and changes their space",
          "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Program);
    const Scene start = bench.scene();
    REQUIRE(start.lights[0].space == LightSpace::World);
    const ImVec2 grip = test::in_column(bench, "grip of light 0");
    REQUIRE(grip.y > bench.state.inspector.look_at_y);
    bench.drag(grip, {grip.x, bench.state.inspector.look_at_y - 20});
    CHECK(bench.scene().lights[0].space == LightSpace::Camera);
    CHECK(bench.scene().lights[0].position == start.lights[0].position);
    CHECK(test::in_column(bench, "grip of light 0").y < bench.state.inspector.look_at_y);
    // What that is in a program is named.
    bench.click(test::in_column(bench, "Mistake: Light in wrong space"));
    CHECK(bench.state.inspector.tab == InspectorTab::Mistakes);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("resting on a light's call shows that light alone", "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Program);
    const ImVec2 number = test::in_column(bench, "/lights/1/position/0");
    bench.move({number.x - 60, number.y});
    bench.frames(2);
    CHECK(bench.state.rendered_scene == with_light_alone(bench.scene(), 1));
    test::rest(bench);
    CHECK(bench.state.rendered_scene == bench.scene());
}
