// The badge on the picture names everything that makes the picture differ from the scene, and can undo it.
#include "ui/picture/picture_notes.h"

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/lesson_window.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/picture/draw_picture.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// A change to the picture, and its name on the badge.
struct Change {
    std::string name;
    std::function<void(HeadlessWindow&)> make;
    bool in_scene = false;
};

std::vector<Change> changes() {
    const auto keep_cell = [](HeadlessWindow& bench, bool alone) {
        TermGridState& grid = bench.state.get<TermGridState>();
        bench.state.get<InspectorState>().tab = InspectorTab::Grid;
        if (alone)
            grid.solo = GridCell{1, 1};
        else
            grid.muted = {GridCell{1, 2}};
    };
    return {
        {"Frozen picture", [](HeadlessWindow& bench) { (void)bench.key(Key::F8); }},
        {"Animation",
         [](HeadlessWindow& bench) {
             bench.state.get<AnimateState>().animation.motion = Motion::Turntable;
             bench.state.get<AnimateState>().playing = true;
         }},
        {"Only Bulb: diffuse", [keep_cell](HeadlessWindow& bench) { keep_cell(bench, true); }},
        {"Without Bulb: specular", [keep_cell](HeadlessWindow& bench) { keep_cell(bench, false); }},
        {"B, the stored scene",
         [](HeadlessWindow& bench) {
             (void)bench.key(Key::B, true);
             (void)bench.key(Key::B);
         }},
        {"Off: diffuse, specular",
         [](HeadlessWindow& bench) {
             (void)bench.key(Key::D, false, true);
             (void)bench.key(Key::S, false, true);
         },
         true},
        {"Mistake: Reflect sign",
         [](HeadlessWindow& bench) { bench.scene().shading.mistakes.reflect_sign = true; }, true},
        {"Comparison", [](HeadlessWindow& bench) { (void)bench.key(Key::C); }},
        {"View: Normals", [](HeadlessWindow& bench) { (void)bench.key(Key::I); }},
        {"Over-range stripes", [](HeadlessWindow& bench) { (void)bench.key(Key::O); }},
    };
}

std::vector<std::string> badge_of(const HeadlessWindow& bench) {
    std::vector<std::string> names;
    for (const NamedControl& control : bench.controls())
        if (control.name == "On the picture") names.push_back(control.key);
    return names;
}

/// The bytes of the edited scene's picture, from a separate renderer.
std::vector<std::uint8_t> drawn_alone(HeadlessWindow& bench) {
    Renderer renderer(1);
    return renderer.render(bench.scene(), bench.state.rendered->size).rgba;
}

void open(HeadlessWindow& bench, const std::string& path) {
    bench.state.editor.saved = bench.scene();  // nothing to save
    bench.open(path);
    bench.frames(2);
    REQUIRE(bench.state.editor.document.path == path);
}

}  // namespace

TEST_CASE("the badge says that a mistake changes no pixel", "[ui][window]") {
    HeadlessWindow bench;
    bench.scene().shading.mistakes.reflect_sign = true;
    const auto badge_at_rest = [&] {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        do {
            (void)bench.frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        } while (!bench.state.get<MistakeEffect>().is_known && std::chrono::steady_clock::now() < end);
        const PictureNote note = picture_notes(bench.state).at(0);
        return note.name + note.remark;
    };
    bench.scene().shading.reflection = Reflection::BlinnPhong;  // does not use r
    CHECK(badge_at_rest() == "Mistake: Reflect sign (no effect here)");
    bench.scene().shading.reflection = Reflection::Phong;
    bench.frames(1);
    CHECK(badge_at_rest() == "Mistake: Reflect sign");
}

TEST_CASE("the badge names each change to the picture, its cross undoes the change", "[ui][window][badge]") {
    for (const Change& change : changes()) {
        CAPTURE(change.name);
        HeadlessWindow bench;
        bench.frames(3);
        const Scene plain = bench.scene();
        CHECK(badge_of(bench).empty());
        change.make(bench);
        bench.frames(4);
        CHECK(badge_of(bench) == std::vector<std::string>{change.name});
        bench.click(bench.control("End: " + change.name));
        bench.frames(3);
        CHECK(badge_of(bench).empty());
        CHECK(same_description(bench.scene(), plain));
        CHECK((bench.state.displayed->rgba == drawn_alone(bench)));
        CHECK(bench.state.editor.history.can_undo() == change.in_scene);
    }
}

TEST_CASE("opening another scene ends everything on the badge", "[ui][window][badge]") {
    const TemporaryDirectory folder;
    Scene other = first_scene().scene;
    other.lights[0].intensity = 0.3f;
    const std::string path = folder.file("other.json", scene_text(other));
    for (const Change& change : changes()) {
        if (change.name == "Comparison") continue;  // its parts have labels
        CAPTURE(change.name);
        HeadlessWindow bench;
        bench.frames(3);
        change.make(bench);
        bench.frames(4);
        open(bench, path);
        CHECK(badge_of(bench).empty());
        CHECK(same_description(bench.scene(), other));
        CHECK((bench.state.displayed->rgba == drawn_alone(bench)));
    }
}

TEST_CASE("a mistake in a frozen picture is named and ends with the picture", "[ui][window][badge]") {
    HeadlessWindow bench;
    bench.scene().shading.mistakes.reflect_sign = true;
    bench.frames(3);
    (void)bench.key(Key::F8);
    bench.scene().shading.mistakes = {};
    bench.frames(2);
    CHECK(badge_of(bench) == std::vector<std::string>{"Frozen picture", "Mistake: Reflect sign"});
    for (const NamedControl& control : bench.controls()) CHECK(control.name != "End: Mistake: Reflect sign");
    bench.click_on("End: Frozen picture");
    CHECK(badge_of(bench).empty());
}

TEST_CASE("the badge names a preview instead of B", "[ui][window][badge][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Mistakes);
    (void)bench.key(Key::B, true);
    (void)bench.key(Key::B);
    bench.frames(2);
    const ImVec2 row = test::in_column(bench, "/shading/mistakes/viewer_at_origin_of_world");
    bench.move(row);
    bench.frames(2);
    CHECK(badge_of(bench) == std::vector<std::string>{"Preview: Viewer at origin of world"});
    test::rest(bench);
    CHECK(badge_of(bench) == std::vector<std::string>{"B, the stored scene"});
}

TEST_CASE("a mistake is not named during a lesson's question", "[ui][window][badge][lesson]") {
    const TemporaryDirectory folder;
    (void)folder.file("s.json",
                      R"({"glint": 1, "objects": [{}], "shading": {"mistakes": {"reflect_sign": true}}})");
    HeadlessWindow bench;
    test::drop(bench, folder.file("l.md",
                                  "# Mine\n\n```lesson\ntopic: Own\nscene: s.json\nsize: 32x32\n```\n\n"
                                  "## One\n\n```predict number\nquestion: How much?\nanswer: 0.5\n"
                                  "tolerance: 0.1\n```\n"));
    REQUIRE(is_held(bench.state));
    const auto is_told = [&bench] {
        for (const NamedControl& control : bench.controls())
            if (control.name == "On the picture" || control.key == "/shading/mistakes") return true;
        return false;
    };
    CHECK_FALSE(is_told());
    reveal_unanswered(bench.state);
    bench.frames(3);
    CHECK(is_told());
}

TEST_CASE("a clean picture has no badge", "[ui][window][badge][lecture]") {
    HeadlessWindow bench;
    bench.scene().shading.terms.specular = false;
    bench.frames(2);
    REQUIRE(badge_of(bench).size() == 1);
    (void)bench.key(Key::F10);
    bench.frames(2);
    CHECK(badge_of(bench).empty());
}
