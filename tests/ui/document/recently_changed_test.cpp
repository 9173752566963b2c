// Lectures are not interrupted: the window leaves a changed example without asking and keeps it until the
// window closes. After a lesson, the previous scene returns.
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/document/editor.h"
#include "ui/picture/draw_picture.h"

using namespace glint;
using namespace glint::test;
using test::HeadlessWindow;

namespace {

const std::string scenes = project_file("assets/scenes");

void open_and_wait(HeadlessWindow& bench, const std::string& path) {
    ask_to_open(bench.state, path);
    bench.wait_for_loads();
}

/// A window with an example.
struct ExampleWindow : HeadlessWindow {
    ExampleWindow() {
        state.shipped_scenes = scenes;
        frames(2);
        open_and_wait(*this, scenes + "/still-life.json");
    }
};

/// A window with a changed example.
struct ChangedWindow : ExampleWindow {
    ChangedWindow() {
        scene().lights[0].intensity = 0.123f;
        frames(2);
        REQUIRE(state.editor.unsaved());
    }
};

}  // namespace

TEST_CASE("PgDn leaves a changed example without asking", "[ui][window][lecture]") {
    ChangedWindow bench;
    const std::string path = bench.state.editor.document.path;
    (void)bench.key(Key::PageDown);
    CHECK_FALSE(bench.state.pending.asking);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path != path);
    REQUIRE(bench.state.get<RecentlyChanged>().list.size() == 1);
    CHECK(bench.state.get<RecentlyChanged>().list[0].changed.lights[0].intensity == 0.123f);
}

TEST_CASE("the menu Recently changed restores a changed example and its undo history",
          "[ui][window][lecture]") {
    ChangedWindow bench;
    const std::string path = bench.state.editor.document.path;
    (void)bench.key(Key::PageDown);
    bench.wait_for_loads();
    bench.click_on("File");
    bench.move(bench.control("Recently changed"));
    bench.frames(20);
    bench.click(bench.control("still-life.json"));
    bench.frames(3);
    CHECK(bench.state.editor.document.path == path);
    CHECK(bench.scene().lights[0].intensity == 0.123f);
    CHECK(bench.state.editor.unsaved());
    CHECK(bench.state.get<RecentlyChanged>().list.empty());
    (void)bench.key(Key::Z, true);
    bench.frames(2);
    CHECK_FALSE(bench.state.editor.unsaved());
}

TEST_CASE("Quit never asks about a changed example, but asks about a user's own file",
          "[ui][window][lecture]") {
    ChangedWindow bench;
    CHECK(bench.key(Key::Q, true).quit);
    CHECK_FALSE(bench.state.pending.asking);
    bench.state.shipped_scenes.clear();  // the same file, as if it were the user's
    (void)bench.key(Key::PageDown);
    CHECK(bench.state.pending.asking);
}

TEST_CASE("after a lesson the previous scene returns, and the lesson's changes are kept",
          "[ui][window][lessons]") {
    ExampleWindow bench;
    const Scene before = bench.scene();
    open_and_wait(bench, project_file("assets/lessons/02-lights.md"));
    bench.frames(3);
    REQUIRE(bench.state.get<LessonState>().course);
    CHECK_FALSE(bench.scene() == before);
    reveal_unanswered(bench.state);
    bench.frames(2);
    bench.scene().display.exposure = 0.5f;
    bench.frames(2);
    bench.click(bench.control("Leave"));
    bench.frames(3);
    CHECK(same_description(bench.scene(), before));
    CHECK(bench.state.editor.title() == "still-life.json");
    CHECK_FALSE(bench.state.editor.unsaved());
    REQUIRE(bench.state.get<RecentlyChanged>().list.size() == 1);
    CHECK(bench.state.get<RecentlyChanged>().list[0].changed.display.exposure == 0.5f);
}

// Indices into one scene are never used in a different one.
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

/// A window with that document.
struct ThreeObjectsWindow : HeadlessWindow {
    explicit ThreeObjectsWindow(ImVec2 size = {420, 300}) : HeadlessWindow(size) {
        take_scene(state, three_objects());
        frames(2);
    }
    void pick_middle() {
        const PictureSize size = state.rendered->size;
        click(at_pixel({size.width / 2.0, size.height / 2.0}));
        frames(1);
    }
};

}  // namespace

TEST_CASE("the last picture is used only for a scene with the same surfaces", "[ui][other]") {
    ThreeObjectsWindow bench;
    const PictureSize size = bench.state.rendered->size;
    const auto answers = [&] { return renderer_of_open_scene(bench.state, size) != nullptr; };
    CHECK(answers());
    bench.scene().lights[0].intensity = 3;
    bench.scene().objects[2].material.diffuse = {1, 0, 0};
    CHECK(answers());  // a different light and colour on the same surfaces
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
    ThreeObjectsWindow bench;
    bench.pick_middle();
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

TEST_CASE("while an animation plays, the WHY column shows its scene, not the edited one", "[ui][other]") {
    ThreeObjectsWindow bench({1280, 500});
    bench.pick_middle();
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
