// When and where a control shows its tooltip.
#include <imgui_internal.h>

#include <algorithm>
#include <string>

#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

const ImGuiWindow* shown_tooltip() {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (window->Active && !window->Hidden && (window->Flags & ImGuiWindowFlags_Tooltip) != 0)
            return window;
    return nullptr;
}

/// The largest alpha drawn in the window, 0 to 255.
ImU32 opacity_of(const ImGuiWindow& window) {
    ImU32 most = 0;
    for (const ImDrawVert& v : window.DrawList->VtxBuffer) most = std::max(most, v.col >> IM_COL32_A_SHIFT);
    return most;
}

/// Long enough for any tooltip, at 60 frames a second.
void wait(HeadlessWindow& bench) { bench.frames(45); }

}  // namespace

TEST_CASE("a tooltip does not return over a clicked control until the mouse has left it",
          "[ui][window][tooltip]") {
    HeadlessWindow bench;
    bench.frames(2);
    const ImVec2 at = test::in_column(bench, "Vectors");
    bench.move(at);
    wait(bench);
    CHECK(shown_tooltip() != nullptr);
    bench.button(true);
    bench.button(false);
    wait(bench);
    CHECK(shown_tooltip() == nullptr);
    bench.move({at.x + 2, at.y});
    wait(bench);
    CHECK(shown_tooltip() == nullptr);
    bench.move({at.x, 795});
    bench.frames(2);
    bench.move(at);
    bench.frames(2);
    CHECK(shown_tooltip() == nullptr);  // it has started hovering again
    wait(bench);
    CHECK(shown_tooltip() != nullptr);
}

TEST_CASE("a key hides the tooltip, which would cover what the key opened", "[ui][window][tooltip]") {
    HeadlessWindow bench;
    bench.frames(2);
    const ImVec2 at = test::in_column(bench, "Vectors");
    bench.move(at);
    wait(bench);
    CHECK(shown_tooltip() != nullptr);
    bench.key(Key::K, true);
    wait(bench);
    CHECK(bench.state.palette.open);
    CHECK(shown_tooltip() == nullptr);
}

TEST_CASE("a field's tooltip stays in its column and does not cover the picture", "[ui][window][tooltip]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    const Rect picture = lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1).centre;
    int seen = 0;
    for (const NamedControl& control : std::vector<NamedControl>(bench.controls())) {
        if (!control.in_sight || control.key.find('/') != 0 || control.at.low.y < 40) continue;
        const Rect item = control.at;
        if (picture.holds(item.middle())) continue;
        bench.move({5, 795});
        bench.frames(2);
        bench.move(item.middle());
        wait(bench);
        const ImGuiWindow* tip = shown_tooltip();
        if (tip == nullptr) continue;
        ++seen;
        INFO(control.name << " " << control.key);
        CHECK((tip->Pos.x + tip->Size.x <= picture.low.x || tip->Pos.x >= picture.high.x));
        CHECK((tip->Pos.y >= item.high.y ||
               tip->Pos.y + tip->Size.y <= item.low.y));  // and does not cover its own field
        CHECK(tip->Pos.y >= 0);
        CHECK(tip->Pos.y + tip->Size.y <= ImGui::GetIO().DisplaySize.y);
    }
    CHECK(seen > 10);
}

TEST_CASE("a read-only number of B does not explain how to edit it", "[ui][window][tooltip]") {
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
    bench.click(bench.control("Edit"));
    bench.frames(2);
    const ImVec2 at = bench.control("Duplicate");
    bench.move(at);
    wait(bench);
    const ImGuiWindow* tip = shown_tooltip();
    REQUIRE(tip != nullptr);
    // Its text is not stored; the height shows that there is a line below the title.
    CHECK(tip->Size.y > 2 * ImGui::GetTextLineHeight());
}

TEST_CASE("tooltips and menus of disabled or dimmed controls are opaque", "[ui][window][tooltip]") {
    HeadlessWindow bench;
    bench.scene().shading.reflection = Reflection::BlinnPhong;  // this model has no roughness
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    const auto tooltip_at = [&](ImVec2 at) {
        bench.move({5, 795});
        bench.frames(2);
        bench.move(at);
        wait(bench);
        REQUIRE(shown_tooltip() != nullptr);
        return opacity_of(*shown_tooltip());
    };
    run_command(bench.state, CommandId::Pen);
    bench.frames(2);
    CHECK(tooltip_at(bench.control("Wipe")) == 255);  // disabled: nothing is drawn yet
    const ImVec2 roughness = bench.control("/objects/0/material/roughness");
    CHECK(tooltip_at(roughness) == 255);
    bench.button(true, 1);
    bench.button(false, 1);
    bench.frames(2);
    const ImGuiWindow* menu = ImGui::GetCurrentContext()->OpenPopupStack.back().Window;
    REQUIRE(menu != nullptr);
    CHECK(opacity_of(*menu) == 255);
}
