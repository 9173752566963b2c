// Tests of the table of actions and everything that uses it.
#include <set>

#include "models/fields/choices.h"
#include "tests/support/catch.h"
#include "tests/support/person.h"
#include "ui/commands/command.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// The value under /shading that differs, in the form that controls use: "/shading/mode = \"flat\"".
std::string changed_value(const Scene& before, const Scene& after) {
    const Shading &a = before.shading, &b = after.shading;
    if (a.mode != b.mode) return "/shading/mode = \"" + std::string(choice_of(b.mode).word) + "\"";
    for (const auto& [term, name] : {std::pair{&Terms::emission, "emission"},
                                     {&Terms::ambient, "ambient"},
                                     {&Terms::diffuse, "diffuse"},
                                     {&Terms::specular, "specular"}})
        if (a.terms.*term != b.terms.*term) return std::string("/shading/terms/") + name;
    return {};
}

}  // namespace

TEST_CASE("no two commands share a key", "[ui][commands]") {
    std::set<std::string> shown;
    for (const WindowCommand& command : commands())
        for (const KeyPress& press : command.keys) {
            INFO(command.name << ": " << text_of(press));
            CHECK(press.key != Key::Other);
            CHECK(shown.insert(text_of(press)).second);
        }
}

TEST_CASE("each key pressed in a frame is reported, a rejected key gives a warning",
          "[ui][window][commands]") {
    DrawnWindow bench;
    const auto& notes = bench.state.notifications.list;
    UiInput input;
    input.presses = {{Key::S, false, true}, {Key::D, false, true}, {Key::B}};  // no scene is stored as B
    (void)bench.frame(input);
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].text.starts_with(
        "Specular: off (Shift+S)\nDiffuse: off (Shift+D)\nNo scene is stored as B"));
    CHECK(notes[0].tone == Tone::Warning);
    (void)bench.key(Key::S, false, true);
    REQUIRE(notes.size() == 1);  // the second message replaces the first
    CHECK(notes[0].text == "Specular: on (Shift+S)");
}

TEST_CASE("a shortcut's text names the keys to press", "[ui][commands]") {
    CHECK(text_of({Key::A}) == "A");
    CHECK(text_of({Key::Z, true, true}) == "Ctrl+Shift+Z");
    CHECK(text_of({Key::Digit1}) == "1");
    CHECK(text_of({Key::Pad7, true}) == "Ctrl+pad 7");
    CHECK(text_of({Key::PadPoint}) == "pad .");
    CHECK(text_of({Key::Delete}) == "Del");
    CHECK(text_of({Key::PageDown}) == "PgDn");
    CHECK(text_of({Key::F12}) == "F12");
    CHECK(text_of({Key::Question, false, true}) == "?");
    CHECK(keys_of(CommandId::Redo) == "Ctrl+Shift+Z or Ctrl+Y");
}

TEST_CASE("every command has an effect, and each CommandId has one row", "[ui][commands]") {
    std::set<CommandId> named;
    for (const WindowCommand& command : commands()) {
        INFO(command.name);
        CHECK(command.run != nullptr);
        if (command.id != CommandId::None) CHECK(named.insert(command.id).second);
    }
    CHECK(named.size() + 1 == static_cast<std::size_t>(CommandId::Count));  // except None
}

TEST_CASE("a command changes the scene value whose controls show its keys", "[ui][commands]") {
    int held = 0;
    for (const WindowCommand& command : commands()) {
        const std::string sets = command.sets;
        if (sets.empty()) continue;
        INFO(command.name << " sets " << sets);
        CHECK_FALSE(keys_of_value(sets).empty());
        HeadlessWindow bench;
        bench.scene().shading.mode = sets.ends_with("\"flat\"") ? ShadingMode::Phong : ShadingMode::Flat;
        const Scene before = bench.scene();
        run_command(bench.state, command);
        const std::string pointer = sets.substr(0, sets.find(' '));
        CHECK(changed_value(before, bench.scene()).starts_with(pointer));
        if (const auto quote = sets.find('"'); quote != std::string::npos)
            CHECK(changed_value(before, bench.scene()) == sets);
        ++held;
    }
    CHECK(held == 8);
}

TEST_CASE("the keys shown by controls are those in the table of commands", "[ui][commands]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.frames(2);
    const auto shown_at = [&](const char* control) {
        for (const NamedControl& c : bench.controls())
            if (c.name == control && !c.shortcut.empty()) return c.shortcut;
        return std::string();
    };
    CHECK(shown_at("Flat") == "1");
    CHECK(shown_at("Facet") == "2");
    CHECK(shown_at("Gouraud") == "3");
    CHECK(shown_at("Phong") == "4");  // the mode; the reflection model of that name has no key
    CHECK(shown_at("Emission") == "Shift+E");
    CHECK(shown_at("Specular") == "Shift+S");
    const auto key_at = [&](const char* control) {
        for (const NamedControl& c : bench.controls())
            if (c.name == control) return c.key;
        return std::string();
    };
    CHECK(key_at("Above") == "pad 7");
    CHECK(key_at("Behind") == "Ctrl+pad 1");
    CHECK(key_at("Redo") == "Ctrl+Shift+Z or Ctrl+Y");
}

TEST_CASE("pressing a key reports the quantity shown, and undo replaces that message", "[ui][commands]") {
    DrawnWindow bench;
    bench.key(Key::I);
    const auto& list = bench.state.notifications.list;
    REQUIRE(list.size() == 1);
    CHECK(list[0].text == "Normals in place of the picture (I)");
    bench.key(Key::L, false, true);
    bench.frames(2);
    REQUIRE(list.size() == 1);
    CHECK(list[0].text.find("(Shift+L)") != std::string::npos);
    bench.key(Key::Z, true);
    REQUIRE(list.size() == 1);
    CHECK(list[0].text.starts_with("Undone: Add "));
}

TEST_CASE("the palette finds or opens each command once", "[ui][commands]") {
    HeadlessWindow bench;
    const auto entries = palette_entries(bench.state);
    for (const WindowCommand& command : commands()) {
        if (command.id == CommandId::Palette) continue;
        int found = 0;
        for (const PaletteEntry& entry : entries) found += entry.name == command.name;
        INFO(command.name);
        CHECK(found == 1);
    }
}

TEST_CASE("a search ranks name starts first, then word starts, substrings and letters", "[ui][palette]") {
    CHECK(match_rank("save AS", "Save as") == 0);
    CHECK(match_rank("lit-in_srgb", "lit in sRGB") == 0);
    CHECK(match_rank("", "Save as") == 1);
    CHECK(match_rank("PHONG", "Phong shading") == 1);
    CHECK(match_rank("sha", "Flat shading") == 2);
    CHECK(match_rank("shading ph", "Phong shading") == 2);  // each word is matched separately
    CHECK(match_rank("versed", "Mistake: light direction reversed") == 3);
    CHECK(match_rank("gs", "Gouraud shading") == 4);
    CHECK(match_rank("shdng", "Gouraud shading") == 4);
    CHECK(match_rank("dirrev", "Mistake: light direction reversed") == 4);
    CHECK_FALSE(match_rank("sz", "Save as"));
    CHECK_FALSE(match_rank("as", ""));
    CHECK_FALSE(match_rank("hdng", "Phong shading"));  // the first letter begins no word
    CHECK_FALSE(match_rank("shading flat", "Phong shading"));
}

TEST_CASE("Ctrl+K, a few letters and Enter run the best match", "[ui][palette]") {
    HeadlessWindow bench;
    bench.frame();
    bench.key(Key::K, true);
    REQUIRE(bench.state.palette.open);
    bench.frame();
    bench.type("gourau");
    CHECK(bench.state.palette.text == "gourau");
    bench.key(Key::Enter);
    CHECK_FALSE(bench.state.palette.open);
    CHECK(bench.scene().shading.mode == ShadingMode::Gouraud);
    bench.frames(3);
    CHECK(bench.state.editor.history.undo_name().starts_with("Shading mode: "));
}

TEST_CASE("a disabled command is listed with its reason and does not run", "[ui][palette]") {
    HeadlessWindow bench;
    bench.frame();
    bench.key(Key::K, true);
    bench.frame();
    bench.type("redo");
    const auto matches = palette_matches(bench.state.palette.entries, "redo");
    REQUIRE_FALSE(matches.empty());
    CHECK(bench.state.palette.entries[std::size_t(matches[0])].refused == "Nothing to redo");
    bench.key(Key::Enter);
    CHECK(bench.state.palette.open);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.state.palette.open);
}

TEST_CASE("keys alone select a light, set its kind and space, and type a number", "[ui][commands]") {
    DrawnWindow bench;
    const auto choose = [&](const char* letters) {
        bench.key(Key::K, true);
        bench.frame();
        bench.type(letters);
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
    choose((name + ": attach").c_str());
    CHECK(bench.scene().lights[0].space == LightSpace::Camera);

    choose("select camera");
    bench.key(Key::Tab);
    bench.frames(2);
    CHECK(ImGui::GetIO().WantTextInput);
    bench.type("7");  // replaces the contents of the first field, the eye's x
    CHECK(bench.scene().camera.eye.x == 7);
    CHECK_FALSE(bench.scene().shading.mode == ShadingMode::Flat);  // keys are now entered as text
}

TEST_CASE("each menu lists its own actions, and none lists the shading keys", "[ui][window][commands]") {
    constexpr std::pair<const char*, const char*> menus[] = {{"File", "Save as…"},
                                                             {"Edit", "Duplicate"},
                                                             {"View", "Picture alone"},
                                                             {"Inspect", "Big pixels"},
                                                             {"Compare", "Store the scene as B"},
                                                             {"Lecture", "Erase all pen strokes"},
                                                             {"Help", "Keys and mouse"}};
    for (const auto& [menu, own] : menus) {
        test::Person person;
        person.clicks(menu);
        CAPTURE(menu);
        for (const auto& [other, action] : menus) CHECK(person.sees(action) == (action == own));
        CHECK_FALSE(person.sees("Flat shading"));
    }
}
