// The table of actions, and what reads it.
#include "ui/commands/actions.h"

#include <set>

#include "tests/support/catch.h"
#include "tests/support/ui_bench.h"
#include "ui/commands/fuzzy.h"
#include "ui/commands/palette.h"

using namespace glint;
using test::Bench;

namespace {

void type(Bench& bench, const char* letters) {
    for (; *letters != 0; ++letters) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(*letters));
    bench.frames(2);
}

}  // namespace

TEST_CASE("no two actions share a key", "[ui][actions]") {
    for (const ActionInfo& a : actions())
        for (const ActionInfo& b : actions())
            if (&a < &b && a.press.key != Key::Other) {
                INFO(a.name << " and " << b.name << ": " << a.keys);
                CHECK_FALSE(a.press == b.press);
            }
}

TEST_CASE("an action shows keys exactly if it has some, and no two show the same", "[ui][actions]") {
    std::set<std::string> shown;
    for (const ActionInfo& info : actions()) {
        INFO(info.name);
        CHECK((*info.keys == 0) == (info.press.key == Key::Other));
        if (*info.keys != 0) CHECK(shown.insert(info.keys).second);
        const std::string keys = info.keys;
        CHECK((keys.find("Ctrl+") != std::string::npos) == info.press.ctrl);
        CHECK((keys.find("Alt+") != std::string::npos) == info.press.alt);
        if (keys != "?") CHECK((keys.find("Shift+") != std::string::npos) == info.press.shift);
    }
}

TEST_CASE("every action is found by the palette or opens it, once", "[ui][actions]") {
    Bench bench;
    const auto entries = palette_entries(bench.state);
    for (const ActionInfo& info : actions()) {
        if (info.action == Action::Palette) continue;
        int found = 0;
        for (const PaletteEntry& entry : entries) found += entry.name == info.name;
        INFO(info.name);
        CHECK(found == 1);
    }
}

TEST_CASE("words match by their letters in order, beginnings of words first", "[ui][palette]") {
    CHECK(fuzzy_match("", "Save as").has_value());
    CHECK_FALSE(fuzzy_match("sz", "Save as").has_value());
    CHECK_FALSE(fuzzy_match("as", "").has_value());
    CHECK(fuzzy_match("PHONG", "Phong shading").has_value());
    CHECK(fuzzy_match("shading ph", "Phong shading").has_value());
    CHECK(fuzzy_match("sa", "Save as…")->bytes == std::vector<int>{0, 1});
    CHECK(fuzzy_match("ca", "Creases: all")->bytes == std::vector<int>{0, 9});
    CHECK(fuzzy_match("gs", "Gouraud shading")->score > fuzzy_match("gs", "Highlights lost")->score);
    CHECK(fuzzy_match("sha", "Flat shading")->score > fuzzy_match("sha", "shininess as fraction")->score);
    CHECK(fuzzy_match("save", "Save")->score > fuzzy_match("save", "Save as…")->score);
}

TEST_CASE("Ctrl+K, a few letters and Enter do what the best match says", "[ui][palette]") {
    Bench bench;
    bench.frame();
    bench.key(Key::K, true);
    REQUIRE(bench.state.palette.open);
    bench.frame();
    type(bench, "gourau");
    CHECK(bench.state.palette.text == "gourau");
    bench.key(Key::Enter);
    CHECK_FALSE(bench.state.palette.open);
    CHECK(bench.scene().shading.mode == ShadingMode::Gouraud);
    bench.frames(3);
    CHECK(bench.state.editor.history.undo_name() == "Shading mode");
}

TEST_CASE("what cannot be done now is shown with its reason and stays undone", "[ui][palette]") {
    Bench bench;
    bench.frame();
    bench.key(Key::K, true);
    bench.frame();
    type(bench, "redo");
    const auto matches = palette_matches(bench.state.palette.entries, "redo");
    REQUIRE_FALSE(matches.empty());
    CHECK(bench.state.palette.entries[std::size_t(matches[0])].refused == "Nothing to redo");
    bench.key(Key::Enter);
    CHECK(bench.state.palette.open);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.state.palette.open);
}

TEST_CASE("by keys alone a light is selected, its kind and space chosen, and a number typed",
          "[ui][actions]") {
    Bench bench;
    bench.frames(2);
    const auto choose = [&](const char* letters) {
        bench.key(Key::K, true);
        bench.frame();
        type(bench, letters);
        bench.key(Key::Enter);
        bench.frames(2);
    };
    const std::string name = bench.scene().lights[0].name;
    choose(("select " + name).c_str());
    REQUIRE(selected_light(bench.state.editor.selection) == 0);
    const LightKind before = bench.scene().lights[0].kind;
    choose((name + ": spot").c_str());
    CHECK(bench.scene().lights[0].kind == LightKind::Spot);
    CHECK(before != LightKind::Spot);
    choose((name + ": ride").c_str());
    CHECK(bench.scene().lights[0].space == LightSpace::Camera);

    choose("select camera");
    bench.key(Key::Tab);
    bench.frames(2);
    CHECK(ImGui::GetIO().WantTextInput);
    type(bench, "7");  // over what the first field, the eye's x, held
    CHECK(bench.scene().camera.eye.x == 7);
    CHECK_FALSE(bench.scene().shading.mode == ShadingMode::Flat);  // keys are text now
}
