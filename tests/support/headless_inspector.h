#pragma once
// Shared by the tests of the WHY column.

#include <imgui_internal.h>

#include <string>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/features/inspector/inspector.h"

namespace glint::test {

/// The ImGui window whose name contains `part`, as of the last frame; null if there was none.
inline const ImGuiWindow* window_named(const std::string& part) {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (window->WasActive && std::string(window->Name).find(part) != std::string::npos) return window;
    return nullptr;
}

/// Opens a tab and picks the pixel at these fractions of the 1280 x 720 picture.
inline void ask(HeadlessWindow& bench, InspectorTab tab, glm::dvec2 share = {0.5, 0.5}) {
    bench.frames(2);
    bench.state.get<InspectorState>().tab = tab;
    bench.state.viewport.probe = share;
    bench.state.viewport.shares_of = {1280, 720};
    bench.frames(3);
}

inline Rect right_column(const HeadlessWindow& bench) {
    return lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1).right;
}

/// The centre of a control in the WHY column.
inline ImVec2 in_column(const HeadlessWindow& bench, std::string_view name_or_key) {
    return HeadlessWindow::middle_of(bench.area_of(name_or_key, right_column(bench)));
}

/// Hovers over a control in the WHY column; returns the control's position.
inline ImVec2 rest_on(HeadlessWindow& bench, std::string_view name_or_key) {
    const ImVec2 at = in_column(bench, name_or_key);
    bench.move(at);
    bench.frames(1);
    return at;
}

/// Moves the mouse away from everything.
inline void rest(HeadlessWindow& bench) {
    ImGui::GetIO().MousePos = {5, 5};
    bench.frames(3);
}

}  // namespace glint::test
