// Text fields, which Dear ImGui edits with 16 bits per character.
#include <imgui.h>

#include <string>

#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "ui/document/document_actions.h"
#include "ui/widgets/widgets.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

constexpr int end_key = 101, return_key = 102, v_key = 103, c_key = 104, a_key = 105;

/// A window with a clipboard and the keys that a text field uses.
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

}  // namespace

TEST_CASE("a name with an emoji survives focus on its field; an edit replaces the emoji",
          "[ui][window][widgets]") {
    const std::string name = "\xF0\x9F\x98\x80 \xE5\x9C\xB0 Ground";
    TypingWindow bench;
    bench.name() = name;
    bench.begin_typing();
    bench.tap(return_key);
    CHECK(bench.name() == name);
    bench.begin_typing();
    bench.tap(end_key);
    bench.type("2");
    CHECK(bench.name() == "\xEF\xBF\xBD \xE5\x9C\xB0 Ground2");
}

TEST_CASE("line breaks pasted into a name become spaces", "[ui][window][widgets]") {
    TypingWindow bench;
    bench.begin_typing();
    bench.tap(a_key, true);
    bench.clipboard = "two\r\nlines\n";
    bench.tap(v_key, true);
    CHECK(bench.name() == "two  lines");
}

TEST_CASE("a byte that is not UTF-8 is pasted as U+FFFD, which can be saved", "[ui][window][widgets]") {
    TypingWindow bench;
    bench.begin_typing();
    bench.tap(a_key, true);
    bench.clipboard = "Sun\xFF";
    bench.tap(v_key, true);
    CHECK(bench.name() == "Sun\xEF\xBF\xBD");
    CHECK(problem_of(parse_scene(scene_text(bench.scene()), "typed.json")) == nullptr);
}
