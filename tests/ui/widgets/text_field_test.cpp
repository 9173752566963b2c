// Names of any bytes in fields that hold 16 bits a character.
#include "ui/widgets/text/text_field.h"

#include <imgui.h>

#include <random>
#include <string>

#include "models/io/utf8.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "ui/document/document_actions.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

constexpr int end_key = 101, return_key = 102, v_key = 103, c_key = 104, a_key = 105;

/// A window with a clipboard and the keys that a text field listens to.
struct TypingWindow : HeadlessWindow {
    TypingWindow() {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyMap[ImGuiKey_End] = end_key;
        io.KeyMap[ImGuiKey_Enter] = return_key;
        io.KeyMap[ImGuiKey_V] = v_key;
        io.KeyMap[ImGuiKey_C] = c_key;
        io.KeyMap[ImGuiKey_A] = a_key;
        test::use_clipboard(clipboard);
        state.editor.selection = {Selection::Kind::Object, 0};
        frames(2);
    }
    void tap(int key, bool ctrl = false) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyCtrl = ctrl;
        io.KeyMods = ctrl ? ImGuiKeyModFlags_Ctrl : ImGuiKeyModFlags_None;
        io.KeysDown[key] = true;
        (void)frame();
        io.KeysDown[key] = io.KeyCtrl = false;
        io.KeyMods = ImGuiKeyModFlags_None;
        frames(2);
    }
    std::string& name() { return scene().objects[0].name; }
    void begin_typing() {
        click(control("Name"));
        frames(2);
    }
    std::string clipboard;
};

constexpr const char* odd_names[] = {"\xF0\x9F\x98\x80 Ground", "b\xF0\x9F\x98\x80\xF0\x9F\x98\x81z",
                                     "\xEE\x80\x80 private", "\xE5\x9C\xB0 \xD7\xA9"};

}  // namespace

TEST_CASE("any bytes come back out of a text field, which holds characters of 16 bits", "[ui][widgets]") {
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        for (std::size_t length = random() % 12; length > 0; --length)
            text += random() % 3 == 0 ? odd_names[random() % 4]
                                      : std::string(1, static_cast<char>(random() % 256));
        const std::string held = held_in_field(text);
        CHECK(taken_from_field(held) == text);
        CHECK(first_invalid_utf8(held) == held.size());
        CHECK(held.find('\0') == held.npos);
        for (const char byte : held)
            CHECK(static_cast<unsigned char>(byte) < 0xF0);  // no character of four bytes
    }
}

TEST_CASE(
    "a name keeps emoji and bytes that are not UTF-8 when its field is visited, typed in, copied and pasted",
    "[ui][window][widgets]") {
    for (const std::string name : odd_names) {
        CAPTURE(name);
        TypingWindow bench;
        bench.name() = name;
        bench.begin_typing();
        bench.tap(return_key);
        CHECK(bench.name() == name);
        bench.begin_typing();
        bench.tap(a_key, true);
        bench.tap(c_key, true);
        CHECK(bench.clipboard == name);
        bench.tap(end_key);
        bench.type("2");
        CHECK(bench.name() == name + "2");
        bench.clipboard = "\xF0\x9F\x98\x82";
        bench.tap(v_key, true);
        CHECK(bench.name() == name + "2\xF0\x9F\x98\x82");
    }
}

TEST_CASE("a byte that is not UTF-8 is pasted into a name as U+FFFD, with which the scene can be saved",
          "[ui][window][widgets]") {
    TypingWindow bench;
    bench.begin_typing();
    bench.tap(a_key, true);
    bench.clipboard = "Sun\xFF\xF0\x9F\x98\x80";
    bench.tap(v_key, true);
    CHECK(bench.name() == "Sun\xEF\xBF\xBD\xF0\x9F\x98\x80");
    CHECK(problem_of(parse_scene(scene_text(bench.scene()), "typed.json")) == nullptr);
}

TEST_CASE("a scene is saved beside a mesh whose name has an emoji or a byte that is not UTF-8",
          "[ui][window][widgets]") {
    for (const std::string name : {"\xF0\x9F\x98\x80m.json",
                                   "b\xFF"
                                   "ad.json"}) {
        CAPTURE(name);
        const TemporaryDirectory folder;
        TypingWindow bench;
        bench.state.files.ask(FilePurpose::SaveScene, folder.path(name));
        bench.frames(3);
        (void)bench.key(Key::Enter);
        bench.frames(2);
        CHECK(folder.names() == std::vector<std::string>{name});
    }
}

TEST_CASE("a search takes as much of what is pasted as fits, whole characters of it",
          "[ui][window][widgets]") {
    TypingWindow bench;
    bench.state.palette = {};
    (void)bench.key(Key::K, true);
    bench.frames(2);
    const std::string& text = bench.state.palette.text;
    std::string long_text;
    for (int i = 0; i < 200'000; ++i) long_text += "e \xC3\xA9";
    bench.clipboard = "x" + long_text;  // the last é would end at 101
    bench.tap(v_key, true);
    CHECK(text == bench.clipboard.substr(0, 99));
    bench.type("yz");
    CHECK(text == bench.clipboard.substr(0, 99) + "y");
    bench.tap(a_key, true);
    bench.clipboard = long_text;  // in place of all
    bench.tap(v_key, true);
    CHECK(text == long_text.substr(0, 100));
    bench.tap(a_key, true);
    bench.type("gou");
    bench.clipboard = "raud" + long_text;
    bench.tap(v_key, true);
    CHECK(text == "gou" + bench.clipboard.substr(0, 97));
}

TEST_CASE("the search for a number to animate takes no more than a search may be long",
          "[ui][window][widgets][animate]") {
    TypingWindow bench;
    begin_animation(bench.state, Motion::PingPong);
    bench.frames(4);
    bench.clipboard = std::string(100'000, 'e');
    bench.tap(v_key, true);
    CHECK(bench.state.animate.search == std::string(100, 'e'));
}
