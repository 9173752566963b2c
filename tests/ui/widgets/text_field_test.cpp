// Text fields, which Dear ImGui edits with 16 bits per character.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string>

#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
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
    void begin_typing() { click_on("Name"); }
    std::string clipboard;
};

}  // namespace

TEST_CASE("a name with an emoji survives focus on its field, an edit replaces the emoji",
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

// When and where a control shows its tooltip.
namespace {

const ImGuiWindow* shown_tooltip() {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (window->Active && !window->Hidden && (window->Flags & ImGuiWindowFlags_Tooltip) != 0)
            return window;
    return nullptr;
}

/// Long enough for any tooltip, at 60 frames a second.
void wait(HeadlessWindow& bench) { bench.frames(45); }

}  // namespace

TEST_CASE("the tooltip for a read-only number in B does not explain how to edit it",
          "[ui][window][tooltip]") {
    HeadlessWindow bench({1280, 1000});
    bench.frames(2);
    bench.key(Key::B, true);
    bench.scene().lights[0].name = "edited";
    bench.state.get<InspectorState>().tab = InspectorTab::Equation;
    bench.click(bench.at_pixel(
        glm::dvec2(bench.state.rendered->size.width, bench.state.rendered->size.height) / 2.0));
    bench.frames(2);
    const auto height_of_tooltip = [&] {
        bench.move({5, 795});
        bench.frames(2);
        bench.move(test::in_column(bench, "/objects/0/material/diffuse/0"));
        wait(bench);
        REQUIRE(shown_tooltip() != nullptr);
        return shown_tooltip()->Size.y;
    };
    const float edited = height_of_tooltip();
    bench.key(Key::B);
    bench.frames(2);
    CHECK(height_of_tooltip() < edited - 10);
}

TEST_CASE("a name is drawn completely, including the part after two hashes", "[ui][window]") {
    HeadlessWindow bench;
    bench.frames(1);
    for (const char* name : {"key", "#", "key ## red", "##", "###1", "a##b###c####"}) {
        const std::string label = whole_label(name);
        CHECK(ImGui::FindRenderedTextEnd(label.c_str()) == label.c_str() + label.size());
        CHECK(ImGui::CalcTextSize(label.c_str(), nullptr, true).x == ImGui::CalcTextSize(name).x);
    }
    CHECK(whole_label("two\nlines\tand\rmore") == "two lines and more");
    CHECK(whole_label(std::string("no\0end", 6)) == "no end");
}

TEST_CASE("a menu explains why an item is disabled", "[ui][window][tooltip]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.frames(2);
    bench.click_on("Edit");
    const ImVec2 at = bench.control("Duplicate");
    bench.move(at);
    wait(bench);
    const ImGuiWindow* tip = shown_tooltip();
    REQUIRE(tip != nullptr);
    // Its text is not stored; the height shows that there is a line below the title.
    CHECK(tip->Size.y > 2 * ImGui::GetTextLineHeight());
}
