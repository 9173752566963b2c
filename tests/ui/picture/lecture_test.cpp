// The window's features for lecturing.
#include "ui/features/lecture/lecture.h"

#include <algorithm>
#include <utility>

#include "models/io/file.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"

using namespace glint;
using test::HeadlessWindow;

TEST_CASE("names are sorted in natural order", "[ui][lecture]") {
    const std::vector<std::string> ordered{"1",        "2",         "10",    "Step 2", "step 10",
                                           "step 10b", "step 010c", "steps", "Z1",     "z2"};
    for (std::size_t i = 0; i < ordered.size(); ++i)
        for (std::size_t k = 0; k < ordered.size(); ++k) {
            INFO(ordered[i] << " and " << ordered[k]);
            CHECK(natural_less(ordered[i], ordered[k]) == (i < k));
        }
    CHECK(natural_less("a01", "a1") != natural_less("a1", "a01"));
    CHECK_FALSE(natural_less("", ""));
    CHECK(natural_less("99999999999999999999998", "99999999999999999999999"));
}

TEST_CASE("PgDn and PgUp go through a folder's scenes in natural order and stop at its ends",
          "[ui][lecture]") {
    const TemporaryDirectory folder;
    for (const char* name : {"s10.json", "s2.json", "s1.json"}) {
        SceneDocument document = first_scene();
        document.scene.lights[0].name = name;
        (void)folder.file(name, scene_text(document.scene));
    }
    (void)folder.file("s3.obj", "");
    (void)folder.file(".s4.json", "");
    CHECK(scene_beside(folder.path("s1.json"), -1).empty());
    CHECK(scene_beside(folder.path("s3.json"), 1) == folder.path("s10.json"));  // s3.json is deleted
    CHECK(scene_beside(folder.path("s3.json"), -1) == folder.path("s2.json"));
    CHECK(scene_beside("/nowhere/at/all.json", 1).empty());
    HeadlessWindow bench;
    bench.open(folder.path("s1.json"));
    for (const char* name : {"s2.json", "s10.json", "s10.json"}) {
        bench.key(Key::PageDown);
        bench.wait_for_loads();
        CHECK(bench.scene().lights[0].name == name);
    }
    bench.key(Key::PageUp);
    bench.wait_for_loads();
    CHECK(bench.scene().lights[0].name == "s2.json");
}

TEST_CASE("a folder's scenes follow its lecture_order.txt, PgDn reports the last one", "[ui][lecture]") {
    const TemporaryDirectory folder;
    for (const char* name : {"a.json", "b.json", "c.json"})
        (void)folder.file(name, scene_text(first_scene().scene));
    (void)folder.file("lecture_order.txt", "c\na\n");
    CHECK(folder_scenes(folder.path("")) ==
          std::vector<std::string>{folder.path("c.json"), folder.path("a.json"), folder.path("b.json")});
    HeadlessWindow bench;
    bench.open(folder.path("c.json"));
    for (const char* name : {"a.json", "b.json", "b.json"}) {
        bench.state.notifications.list.clear();
        bench.key(Key::PageDown);
        bench.wait_for_loads();
        CHECK(bench.state.editor.document.path == folder.path(name));
    }
    REQUIRE(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.notifications.list[0].text == "This is the last scene");
}

TEST_CASE("PgDn goes through the scenes given on the command line in order", "[ui][lecture]") {
    const TemporaryDirectory folder;
    std::vector<std::string> given;
    for (const char* name : {"z.json", "a.json"})
        given.push_back(folder.file(name, scene_text(first_scene().scene)));
    (void)folder.file("b.json", scene_text(first_scene().scene));
    HeadlessWindow bench;
    bench.state.get<LectureState>().given_scenes = given;
    bench.open(given[0]);
    bench.key(Key::PageDown);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path == given[1]);
    bench.key(Key::PageDown);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path == given[1]);  // not b.json, which is in the same folder
    bench.key(Key::PageUp);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path == given[0]);
    run_command(bench.state,
                test::command_named("New scene"));  // a scene without a file does not end the list
    bench.frames(2);
    REQUIRE(bench.state.editor.document.path.empty());
    bench.key(Key::PageDown);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path == given[1]);
}

TEST_CASE("an unreadable page is reported, and PgDn and PgUp skip it", "[ui][lecture]") {
    const TemporaryDirectory folder;
    for (const char* name : {"1.json", "4.json"}) (void)folder.file(name, scene_text(first_scene().scene));
    for (const char* name : {"2.json", "3.json"}) (void)folder.file(name, "{");
    const bool given = GENERATE(false, true);
    HeadlessWindow bench;
    if (given)
        for (const char* name : {"1.json", "2.json", "3.json", "4.json"})
            bench.state.get<LectureState>().given_scenes.push_back(folder.path(name));
    bench.open(folder.path("1.json"));
    const auto page = [&](Key key) {
        bench.state.notifications.list.clear();
        bench.key(key);
        bench.wait_for_loads();
        const auto& told = bench.state.notifications.list;
        return std::pair(bench.state.editor.title(), told.empty() ? "" : told[0].text);
    };
    const auto fails = [&](Key key, const char* stays, const char* name) {
        const auto [title, told] = page(key);
        CHECK(title == stays);
        CHECK(told.find(name) != std::string::npos);
    };
    fails(Key::PageDown, "1.json", "2.json");
    // In the other direction, the next page is relative to the open one.
    CHECK(page(Key::PageUp).second == "This is the first scene");
    fails(Key::PageDown, "1.json", "3.json");
    CHECK(page(Key::PageDown).first == "4.json");
    CHECK(page(Key::PageDown).second == "This is the last scene");
    fails(Key::PageUp, "4.json", "3.json");
    bench.open(folder.path("1.json"));
    fails(Key::PageDown, "1.json", "2.json");  // relative to the document that was opened
}

TEST_CASE("on the projector all text has a contrast of 7 to 1", "[ui][lecture]") {
    for (const bool dark : {true, false}) {
        const Theme& t = projector_theme(dark);
        CHECK(t.dark == dark);
        for (const ImVec4& ground : {t.window, t.panel, t.field, t.field_hovered, t.field_active}) {
            CHECK(contrast(t.text, ground) >= 7);
            CHECK(contrast(t.dim_text, ground) >= 7);
            CHECK(contrast(t.warning, ground) >= 7);
            CHECK(contrast(t.error, ground) >= 7);
        }
        for (const ImVec4& ground : {t.window, t.panel, t.field})
            for (const ImVec4& symbol : t.symbols) CHECK(contrast(symbol, ground) >= 7);
        CHECK(contrast(t.accent_text, t.accent) >= 7);
        CHECK(contrast(t.accent, t.panel) >= 7);
    }
    CHECK(13 * projector_scale >= 18);  // the smallest text size
}

TEST_CASE("a clean picture shows only messages that need attention", "[ui][lecture]") {
    HeadlessWindow bench;
    bench.key(Key::F10);
    bench.state.notifications.add(Tone::Done, "Saved");
    bench.frames(3);
    CHECK(test::window_named("##note") == nullptr);
    bench.state.notifications.add(Tone::Warning, "Look");
    bench.frames(3);
    CHECK(test::window_named("##note") != nullptr);
}

TEST_CASE("a frozen picture does not change during edits", "[ui][lecture]") {
    HeadlessWindow bench;
    bench.frames(2);
    const auto pixels = bench.state.rendered->rgba;
    bench.key(Key::F8);
    bench.scene().lights[0].intensity = 0;
    bench.scene().lights.pop_back();
    bench.frames(3);
    CHECK(bench.state.rendered->rgba == pixels);
    CHECK(bench.state.editor.unsaved());
    bench.click(bench.at_pixel({200, 200}));
    CHECK_FALSE(bench.state.viewport.probe);  // its overlays do not change either
    bench.key(Key::F8);
    bench.frames(2);
    CHECK_FALSE(bench.state.rendered->rgba == pixels);
    bench.click(bench.at_pixel({200, 200}));
    CHECK(bench.state.viewport.probe);
    CHECK(bench.state.rendered_scene == bench.scene());
}

TEST_CASE("the step wedge reports the lost steps", "[ui][lecture]") {
    WedgeRow row{"black", 0, 1};
    CHECK(wedge_words(row) ==
          "On black: click the first patch that is visible from the last row of the room");
    row.seen = 0;
    CHECK(wedge_words(row) == "On black every step is visible");
    row.seen = 4;  // 6 is visible, 4 is not
    CHECK(wedge_words(row) ==
          "On black this projector loses steps below 6/255: colours 0.016 apart look the same");
    HeadlessWindow bench;
    bench.frame();
    run_command(bench.state, test::command_named("Step wedge: what does this projector show?"));
    bench.frames(2);
    bench.click({60, 120});
    CHECK(bench.state.get<WedgeState>().rows[0].seen == 0);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.state.get<WedgeState>().open);
}
