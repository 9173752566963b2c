// The tab "Program": dragging numbers in place, and moving a light's call past gluLookAt by dragging.
#include <fmt/core.h>

#include "models/fields/choices.h"
#include "programs/program.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Shows the tab for the first object alone, with this transform.
void ask_of_one_object(HeadlessWindow& bench, const Transform& transform) {
    bench.scene().objects[0].transform = transform;
    bench.scene().objects.resize(1);
    bench.state.editor.history.reset(bench.scene());
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    test::ask(bench, InspectorTab::Program);
}

}  // namespace

TEST_CASE("a number in a call can be dragged in place, as one undo step", "[ui][window][program]") {
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

TEST_CASE("the command in Copy's tooltip works for the scene, and Copy copies C code",
          "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Program);
    bench.click(test::in_column(bench, "Copy all calls"));
    const std::string copied = ImGui::GetClipboardText();
    CHECK(copied.find("void draw(const GLuint* mesh, int width, int height) {\n") != std::string::npos);
    CHECK(copied.find("rgb(") == std::string::npos);
    const auto is_written = [](const Scene& scene) {
        const std::string words = whole_program_words(scene);
        for (int i = 0; i < 4; ++i) {
            const auto language = static_cast<Language>(i);
            const bool named = words.find(fmt::format("--language {} ", name_of(language))) != words.npos;
            if (named) return problem_of(write_program({scene, {}, ""}, language)) == nullptr;
        }
        return false;
    };
    Scene scene = bench.scene();
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
        for (const Reflection reflection : {Reflection::BlinnPhong, Reflection::CookTorrance}) {
            scene.shading.mode = mode;
            scene.shading.reflection = reflection;
            CAPTURE(mode, reflection);
            CHECK(is_written(scene));
        }
    scene.npr.silhouettes = true;
    CHECK_FALSE(is_written(scene));
    CHECK(whole_program_words(scene) == "glint code cannot write this scene as a program");
}

TEST_CASE("a light's position dragged past gluLookAt keeps its numbers and changes space",
          "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Program);
    const Scene start = bench.scene();
    REQUIRE(start.lights[0].space == LightSpace::World);
    const ImVec2 grip = test::in_column(bench, "grip of light 0");
    REQUIRE(grip.y > bench.state.get<InspectorState>().look_at_y);
    bench.drag(grip, {grip.x, bench.state.get<InspectorState>().look_at_y - 20});
    CHECK(bench.scene().lights[0].space == LightSpace::Camera);
    CHECK(bench.scene().lights[0].position == start.lights[0].position);
    CHECK(test::in_column(bench, "grip of light 0").y < bench.state.get<InspectorState>().look_at_y);
    // The corresponding mistake in a program is named.
    bench.click(test::in_column(bench, "Mistake: Light in wrong space"));
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::Mistakes);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("hovering over a light's call shows that light alone", "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Program);
    const ImVec2 number = test::in_column(bench, "/lights/1/position/0");
    bench.move({number.x - 60, number.y});
    bench.frames(2);
    CHECK(bench.state.rendered_scene == with_light_alone(bench.scene(), 1));
    test::rest(bench);
    CHECK(bench.state.rendered_scene == bench.scene());
}

TEST_CASE("a transform dragged past another keeps its numbers and moves the object",
          "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    ask_of_one_object(bench, {{2, 0, 0}, {0, 0, 90}, {1, 1, 1}});
    const Scene start = bench.scene();
    const ImVec2 translate = test::in_column(bench, "grip of glTranslatef 0");
    const ImVec2 rotate = test::in_column(bench, "grip of glRotatef 0");
    REQUIRE(translate.y < rotate.y);
    const float line = rotate.y - translate.y;
    bench.drag(translate, {translate.x, rotate.y + 2 * line});
    // Computed by hand: Rz(90 degrees) takes (2, 0, 0) to (0, 2, 0).
    const Transform& moved = bench.scene().objects[0].transform;
    CHECK(moved.translate.x == Approx(0).margin(1e-6));
    CHECK(moved.translate.y == Approx(2));
    CHECK(moved.rotate_deg == start.objects[0].transform.rotate_deg);
    CHECK(test::in_column(bench, "grip of glTranslatef 0").y >
          test::in_column(bench, "grip of glRotatef 0").y);
    // The call's first number is still the 2 that was written, and moves the object along the turned axis.
    const ImVec2 x = test::in_column(bench, "/objects/0/transform/translate/0");
    bench.drag(x, {x.x + 40, x.y});
    CHECK(bench.scene().objects[0].transform.translate.y > 2.01f);
    CHECK(bench.scene().objects[0].transform.translate.x == Approx(0).margin(1e-5));
    bench.key(Key::Z, true);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
    // An edit of the transform elsewhere restores the file's order.
    CHECK(test::in_column(bench, "grip of glTranslatef 0").y <
          test::in_column(bench, "grip of glRotatef 0").y);
}

TEST_CASE("a scale that would shear cannot be dragged before a rotation", "[ui][window][program]") {
    HeadlessWindow bench({1280, 1400});
    ask_of_one_object(bench, {{1, 0, 0}, {0, 0, 30}, {1, 2, 1}});
    const Scene start = bench.scene();
    const ImVec2 scale = test::in_column(bench, "grip of glScalef 0");
    const ImVec2 rotate = test::in_column(bench, "grip of glRotatef 0");
    bench.drag(scale, {scale.x, rotate.y - 3});
    CHECK(bench.scene() == start);
    CHECK(test::in_column(bench, "grip of glScalef 0").y > rotate.y);
}
