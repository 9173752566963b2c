// A calm window: controls keep their place, nothing vanishes, keys do nothing unexpected, and there is one
// notification at a time.
#include <fmt/core.h>

#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "ui/fields/field_panel.h"

using namespace glint;
using namespace glint::test;

namespace {

bool shows_control(const HeadlessWindow& bench, std::string_view name) {
    return std::any_of(bench.controls().begin(), bench.controls().end(),
                       [&](const NamedControl& control) { return control.name == name && control.in_sight; });
}

void press(HeadlessWindow& bench, Key key, bool shift = false) {
    (void)bench.key(key, false, shift);
    bench.frames(2);
}

}  // namespace

TEST_CASE("the compare button keeps its place in every view", "[ui][window][shell]") {
    for (const ImVec2 size : {ImVec2(1024, 768), ImVec2(1280, 800)}) {
        HeadlessWindow bench(size);
        bench.frames(3);
        const ImVec2 place = bench.area_of("Compare with wipe lines").low;
        const auto stays = [&] {
            bench.frames(2);
            const ImVec2 now = bench.area_of("Compare with wipe lines").low;
            return now.x == place.x && now.y == place.y;
        };
        for (const Key key : {Key::O, Key::P, Key::M, Key::J, Key::C}) {
            press(bench, key);
            CHECK(stays());
        }
        const ImVec2 difference = bench.control("Difference");
        bench.click(difference);
        CHECK(stays());
        bench.click(difference);  // the button is still there
        CHECK_FALSE(bench.state.get<CompareState>().choice.difference);
        press(bench, Key::C);
        press(bench, Key::I);
        CHECK(stays());
    }
}

TEST_CASE("controls that do not fit are behind an overflow button", "[ui][window][shell]") {
    DrawnWindow bench({1024, 768});
    CHECK(shows_control(bench, "Specular"));
    apply_theme(dark_theme(), 1.5f);  // the projector's text size
    load_fonts({}, 1.5f, 1);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    bench.frames(3);
    for (const char* name : {"Shading", "Reflection"}) CHECK(shows_control(bench, name));
    CHECK_FALSE(shows_control(bench, "Specular"));
    bench.click_on("More");
    for (const char* name : {"Emission", "Ambient", "Diffuse", "Specular", "Undo", "Redo"})
        CHECK(shows_control(bench, name));
}

TEST_CASE("advanced fields are folded unless non-default or searched for", "[ui][window][shell]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Shading, 0};
    bench.frames(3);
    CHECK(shows_control(bench, "Mode"));
    CHECK_FALSE(shows_control(bench, "Interpolate"));
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.frames(3);
    const auto shows_up = [&] {
        return std::any_of(bench.controls().begin(), bench.controls().end(), [](const NamedControl& control) {
            return control.key.starts_with("/camera/up") && control.in_sight;
        });
    };
    CHECK_FALSE(shows_up());
    ask_for_field("/camera/up");
    bench.frames(6);
    CHECK(shows_up());
}

TEST_CASE("the letters W, A, S and D alone change nothing", "[ui][window][commands]") {
    DrawnWindow bench;
    bench.move(bench.at_pixel({300, 300}));
    const Scene before = bench.scene();
    for (const Key key : {Key::W, Key::A, Key::S, Key::D, Key::E, Key::L}) press(bench, key);
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.get<PenState>().on);
    press(bench, Key::D, true);
    CHECK_FALSE(bench.scene().shading.terms.diffuse);
}

TEST_CASE("a letter pressed just after a dialog has closed does nothing", "[ui][window][commands]") {
    DrawnWindow bench;
    bench.scene().lights[0].intensity += 1;
    bench.frames(2);
    (void)bench.key(Key::N, true);
    bench.frames(2);
    REQUIRE(bench.state.pending.asking);
    (void)bench.key(Key::D);  // don't save
    bench.frames(1);
    REQUIRE_FALSE(bench.state.pending.asking);
    (void)bench.key(Key::C);
    CHECK_FALSE(bench.state.get<CompareState>().choice.on);
    bench.frames(20);  // a third of a second
    (void)bench.key(Key::C);
    CHECK(bench.state.get<CompareState>().choice.on);
}

TEST_CASE("a notification replaces the last one, those from one frame are combined", "[ui][window][shell]") {
    DrawnWindow bench;
    Notifications& notes = bench.state.notifications;
    notes.add(Tone::Warning, "first");
    bench.frames(1);
    notes.add(Tone::Done, "second");
    notes.add(Tone::Warning, "third");
    notes.add(Tone::Done, "second");
    REQUIRE(notes.list.size() == 1);
    CHECK(notes.list[0].text == "second\nthird");
    CHECK(notes.list[0].tone == Tone::Warning);
    bench.frames(2);
    int windows = 0;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        windows += window->WasActive && std::string(window->Name).starts_with("##note") ? 1 : 0;
    CHECK(windows == 1);
    notes.add(Tone::Error, "lost");
    bench.frames(2);
    notes.add(Tone::Done, "saved");
    CHECK(notes.list[0].text == "lost\nsaved");  // an error is not replaced before it can be read
}
