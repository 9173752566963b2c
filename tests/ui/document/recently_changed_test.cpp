// Lectures are not interrupted: the window leaves a changed example without asking and keeps it until the
// window closes. After a lesson, the previous scene returns.
#include "tests/places.h"
#include "tests/support/headless_window.h"
#include "ui/document/editor.h"

using namespace glint;
using namespace glint::test;

namespace {

const std::string scenes = project_file("assets/scenes");

void open_and_wait(HeadlessWindow& bench, const std::string& path) {
    ask_to_open(bench.state, path);
    bench.wait_for_loads();
}

/// A window with a changed example.
void change_example(HeadlessWindow& bench) {
    bench.state.shipped_scenes = scenes;
    bench.frames(2);
    open_and_wait(bench, scenes + "/still-life.json");
    bench.scene().lights[0].intensity = 0.123f;
    bench.frames(2);
    REQUIRE(bench.state.editor.unsaved());
}

}  // namespace

TEST_CASE("PgDn leaves a changed example without asking", "[ui][window][lecture]") {
    HeadlessWindow bench;
    change_example(bench);
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
    HeadlessWindow bench;
    change_example(bench);
    const std::string path = bench.state.editor.document.path;
    (void)bench.key(Key::PageDown);
    bench.wait_for_loads();
    bench.click(bench.control("File"));
    bench.frames(2);
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
    HeadlessWindow bench;
    change_example(bench);
    CHECK(bench.key(Key::Q, true).quit);
    CHECK_FALSE(bench.state.pending.asking);
    bench.state.shipped_scenes.clear();  // the same file, as if it were the user's
    (void)bench.key(Key::PageDown);
    CHECK(bench.state.pending.asking);
}

TEST_CASE("after a lesson the previous scene returns, and the lesson's changes are kept",
          "[ui][window][lessons]") {
    HeadlessWindow bench;
    bench.state.shipped_scenes = scenes;
    bench.frames(2);
    open_and_wait(bench, scenes + "/still-life.json");
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
