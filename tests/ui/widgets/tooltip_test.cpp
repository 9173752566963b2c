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
