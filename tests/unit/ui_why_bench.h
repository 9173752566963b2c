#pragma once
// What tests of the WHY column share.

#include <imgui_internal.h>

#include <functional>
#include <string>

#include "tests/catch.h"
#include "tests/unit/ui_bench.h"
#include "ui/why/tabs.h"

namespace glint::test {

/// The window of ImGui whose name holds `part`, in its last frame; null when there was none.
inline const ImGuiWindow* window_named(const std::string& part) {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (window->WasActive && std::string(window->Name).find(part) != std::string::npos) return window;
    return nullptr;
}

/// Opens a tab and picks the pixel at this share of the picture.
inline void ask(Bench& bench, WhyTab tab, glm::dvec2 share = {0.5, 0.5}) {
    bench.frames(2);
    bench.state.why_column.tab = tab;
    bench.state.viewport.probe = share;
    bench.frames(3);
}

inline Rect right_column(const Bench& bench) {
    return lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1).right;
}

/// Rests the mouse down a line of the right column below its tabs, `x` from its left edge, until `found` says
/// so; where that was.
inline ImVec2 search_column(Bench& bench, float x, const std::function<bool()>& found) {
    const Rect column = right_column(bench);
    for (float y = column.low.y + 140; y < column.high.y; y += 4) {
        const ImVec2 at{column.low.x + x, y};
        bench.move(at);
        bench.frames(1);
        if (found()) return at;
    }
    FAIL("nothing in the column does that");
    return {};
}

/// Moves the mouse away from everything.
inline void rest(Bench& bench) {
    ImGui::GetIO().MousePos = {5, 5};
    bench.frames(3);
}

}  // namespace glint::test
