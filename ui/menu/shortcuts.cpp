#include "ui/menu/shortcuts.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/actions.h"
#include "ui/fonts.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace glint {
namespace {

/// What is done, and how.
struct Line {
    std::string does, how;
};
using Lines = std::vector<Line>;

Lines mouse_lines() {
    return {{"Ask why a pixel has its colour", "Click"},
            {"Select an object", "Double-click"},
            {"Orbit", "Drag; on a light or highlight Alt+drag"},
            {"Pan", "Shift+drag, right or middle drag"},
            {"Closer, away", "Wheel, Ctrl+drag"},
            {"Pan, turn with two fingers", "Shift+scroll, Alt+scroll"},
            {"Move a light", "Drag its handle or its highlight"},
            {"Turn the selected light", "Drag its terminator"},
            {"… in depth, along an axis", "with Shift, with X Y Z"},
            {"Open a cone, aim, size a panel", "Drag the marks of the selected light"},
            {"Move, rotate, scale an object", "Select it, drag its gizmo (G R T)"},
            {"… on a grid, cancel", "with Ctrl, Esc"},
            {"Number: finer, type, default", "Shift, Ctrl+click, double-click"}};
}

/// Every action that has a key, once, in the table's order.
Lines key_lines() {
    Lines lines;
    for (const ActionInfo& info : actions())
        if (*info.keys != 0 && &info == &info_of(info.action))
            lines.push_back({info.name, keys_of(info.action)});
    return lines;
}

/// Lines `from` to `to` in two columns.
void sheet(const Lines& lines, std::size_t from, std::size_t to) {
    float widest = 0;
    for (std::size_t i = from; i < to; ++i)
        widest = std::max(widest, ImGui::CalcTextSize(lines[i].does.c_str()).x);
    ImGui::BeginGroup();
    for (std::size_t i = from; i < to; ++i) {
        const float left = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(lines[i].does.c_str());
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + widest +
                             px(14));  // SameLine(offset) counts from the group, this does not
        dim_text(lines[i].how.c_str());
    }
    ImGui::EndGroup();
}

}  // namespace

void shortcuts_sheet(UiState& state) {
    if (!state.shows_shortcuts) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x - px(20), window.y - px(20)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(18), px(14)});
    constexpr auto flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                           ImGuiWindowFlags_HorizontalScrollbar;
    if (ImGui::Begin("Keys and mouse", &state.shows_shortcuts, flags)) {
        ImGui::PushFont(fonts().small);
        const Lines keys = key_lines(), mouse = mouse_lines();
        // The mouse stands above the rest of the keys, so that the columns are about equally high.
        const std::size_t half = (keys.size() + mouse.size() + 2) / 2;
        sheet(keys, 0, std::min(half, keys.size()));
        ImGui::SameLine(0, px(32));
        ImGui::BeginGroup();
        if (half < keys.size()) sheet(keys, half, keys.size());
        ImGui::PushFont(fonts().title);
        ImGui::TextUnformatted("Mouse");
        ImGui::PopFont();
        sheet(mouse, 0, mouse.size());
        ImGui::EndGroup();
        ImGui::PopFont();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace glint
