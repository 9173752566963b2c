// Indices into one scene are never used in a different one.
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/picture/draw_picture.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// A document in which the ball in the middle is the last of three objects; the others are not visible.
SceneDocument three_objects() {
    SceneDocument document = first_scene();
    Object aside = document.scene.objects[0];
    aside.transform.translate = {100, 0, 0};
    document.scene.objects.insert(document.scene.objects.begin(), {aside, aside});
    document.scene.objects[0].name = "One", document.scene.objects[1].name = "Two";
    return document;
}

ImVec2 middle(const HeadlessWindow& bench) {
    const PictureSize size = bench.state.rendered->size;
    return bench.at_pixel({size.width / 2.0, size.height / 2.0});
}

}  // namespace

TEST_CASE("the last picture is used only for a scene with the same surfaces", "[ui][other]") {
    HeadlessWindow bench({420, 300});
    take_scene(bench.state, three_objects());
    bench.frames(2);
    const PictureSize size = bench.state.rendered->size;
    const auto answers = [&] { return renderer_of_open_scene(bench.state, size) != nullptr; };
    CHECK(answers());
    bench.scene().lights[0].intensity = 3;
    bench.scene().objects[2].material.diffuse = {1, 0, 0};
    CHECK(answers());  // different lights on the same surfaces
    CHECK(renderer_of_open_scene(bench.state, {size.width + 1, size.height}) == nullptr);
    const Scene before = bench.scene();
    bench.scene().objects[0].transform.translate.x = 2;
    CHECK_FALSE(answers());
    bench.scene() = before;
    bench.scene().camera.eye.x += 1;
    CHECK_FALSE(answers());
    bench.scene() = before;
    bench.scene().objects.pop_back();
    CHECK_FALSE(answers());
    bench.frames(1);
    CHECK(answers());
    bench.state.get<InspectorState>().instead = before;  // a different scene on the screen
    bench.frames(1);
    CHECK_FALSE(answers());
}

TEST_CASE("a picked object that is deleted is unpicked in the same frame", "[ui][other]") {
    HeadlessWindow bench({420, 300});
    take_scene(bench.state, three_objects());
    bench.frames(2);
    bench.click(middle(bench));
    bench.frames(1);
    REQUIRE(bench.state.on_screen.explanation.has_value());
    REQUIRE(bench.state.on_screen.explanation->object_index == 2);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    UiInput input;
    input.presses = {{Key::Delete}, {Key::R, false, true}};  // delete, rotate about the picked point
    (void)bench.frame(input);
    const Selection& selection = bench.state.editor.selection;
    CHECK(valid_selection(selection, bench.scene()) == selection);
    CHECK_FALSE(bench.state.viewport.pivot.has_value());
}

TEST_CASE("while an animation plays, the column shows its scene, not the edited one", "[ui][other]") {
    HeadlessWindow bench({1280, 500});
    take_scene(bench.state, three_objects());
    bench.frames(2);
    bench.click(middle(bench));
    bench.frames(1);
    REQUIRE(bench.state.on_screen.explanation->object_index == 2);
    Scene played = bench.scene();
    played.lights[0].intensity = 0.5f;
    bench.scene().objects.resize(1);
    bench.state.get<AnimateState>().frame = played;
    bench.frames(1);
    Renderer alone(1);
    (void)alone.render(played, bench.state.rendered->size);
    REQUIRE(bench.state.on_screen.explanation.has_value());
    CHECK(bench.state.on_screen.explanation->sum ==
          alone.explain(bench.state.on_screen.pixel.x, bench.state.on_screen.pixel.y).sum);
    CHECK(explained_scene(bench.state) == played);
    CHECK_FALSE(is_explained(bench.state));
}
