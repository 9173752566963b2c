#include "ui/commands/command.h"
#include "ui/commands/menus.h"
#include "ui/feature.h"
#include "ui/fields/field_panel.h"
#include "ui/shell/columns.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// A short label before a switch, centred in the row.
void caption(const char* text) {
    ImGui::PushFont(fonts().small);
    const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(text);
    ImGui::PopFont();
    const float height = ImGui::GetFrameHeight();
    ImGui::Dummy({size.x, height});
    const ImFont* font = fonts().small;
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize * ImGui::GetIO().FontGlobalScale,
                                        {at.x, at.y + (height - size.y) / 2}, to_u32(theme().dim_text), text);
    ImGui::SameLine(0, px(6));
}

void mode_switch(Shading& shading) {
    const int chosen =
        segments("##mode", static_cast<int>(shading.mode), choices<ShadingMode>, {"", "/shading/mode"});
    shading.mode = static_cast<ShadingMode>(chosen);
}

/// All models side by side if there is room, else a drop-down.
void reflection_switch(Shading& shading, float room) {
    const auto& options = choices<Reflection>;
    int chosen = static_cast<int>(shading.reflection);
    const Help help{"The lighting equation's highlight", "/shading/reflection"};
    if (segments_width(options) <= room) {
        chosen = segments("##reflection", chosen, options, help);
    } else {
        ImGui::SetNextItemWidth(std::max(std::min(room, px(130)), px(40)));
        chosen = drop_down("Reflection", chosen, options, help);
    }
    shading.reflection = static_cast<Reflection>(chosen);
}

/// A round switch with the term's letter in its colour.
void term_switch(const char* letter, const char* name, const char* key, Symbol symbol, bool& on) {
    const float size = ImGui::GetFrameHeight();
    ImGui::PushID(name);
    if (hit_area("##term", {size, size})) on = !on;
    const ImVec2 low = ImGui::GetItemRectMin(), middle{low.x + size / 2, low.y + size / 2};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec4& colour = theme()[symbol];
    const float radius = size / 2 - px(1);
    if (on)
        list.AddCircleFilled(middle, radius, to_u32(colour));
    else
        list.AddCircle(middle, radius, to_u32(ImGui::IsItemHovered() ? colour : theme().disabled_text), 0,
                       px(1.5f));
    const ImVec2 text = ImGui::CalcTextSize(letter);
    const ImVec4& ink = on ? (theme().dark ? theme().window : ImVec4(1, 1, 1, 1)) : theme().dim_text;
    list.AddText({middle.x - text.x / 2, middle.y - text.y / 2}, to_u32(ink), letter);
    tooltip(name, "One term of the equation, on or off", on ? "on" : "off", key);
    ImGui::PopID();
}

void term_switches(Terms& terms) {
    term_switch("e", "Emission", "/shading/terms/emission", Symbol::Emission, terms.emission);
    ImGui::SameLine(0, px(3));
    term_switch("a", "Ambient", "/shading/terms/ambient", Symbol::Ambient, terms.ambient);
    ImGui::SameLine(0, px(3));
    term_switch("d", "Diffuse", "/shading/terms/diffuse", Symbol::Diffuse, terms.diffuse);
    ImGui::SameLine(0, px(3));
    term_switch("s", "Specular", "/shading/terms/specular", Symbol::Specular, terms.specular);
}

/// Undo or redo; `step` is the name of the step, empty when there is none.
void history_button(UiState& state, CommandId id, Icon icon, const std::string& step) {
    const WindowCommand& row = command(id);
    ImGui::BeginDisabled(!can_run(state, row));
    if (icon_button(row.name, icon)) run_command(state, row);
    ImGui::EndDisabled();
    tooltip(row.name, can_run(state, row) ? step.c_str() : why_disabled(state, row).c_str(), "",
            keys_of(row));
}

/// The controls to the right of the menus.
void switches(UiState& state, const Rect& area) {
    Shading& shading = state.editor.scene().shading;
    const float button = ImGui::GetFrameHeight(), gap = px(area.size().x > px(three_column_width) ? 16 : 10);
    const float terms = 4 * button + 3 * px(3), history = 2 * button + px(2), right_end = area.high.x - px(8);
    const bool roomy = area.size().x > px(1400);
    const float y = area.low.y + (area.size().y - button) / 2;
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x + gap, y});
    if (roomy) caption("Shading");
    mode_switch(shading);
    ImGui::SameLine(0, gap);
    if (roomy) caption("Lighting");
    reflection_switch(shading, right_end - ImGui::GetCursorScreenPos().x - terms - history - 2 * gap);
    ImGui::SameLine(0, gap);
    term_switches(shading.terms);
    if (ImGui::GetItemRectMax().x + px(2) > right_end - history) return;  // the keys and the menu do the same
    ImGui::SetCursorScreenPos({right_end - history, y});
    history_button(state, CommandId::Undo, Icon::Undo, state.editor.history.undo_name());
    ImGui::SameLine(0, px(2));
    history_button(state, CommandId::Redo, Icon::Redo, state.editor.history.redo_name());
}

}  // namespace

void toolbar(UiState& state, const Rect& area) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    const float line = ImGui::GetFontSize();
    // ImGui makes the menu bar one frame high: padding makes it fill the row.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(7), (area.size().y - line) / 2});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(4), 0});
    constexpr auto flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::Begin("##top", nullptr, flags);
    const bool open = ImGui::BeginMenuBar();
    if (open) menu_bar(state);
    ImGui::PopStyleVar(2);
    if (open) {
        ImGui::BeginDisabled(is_held(state));
        switches(state, area);
        ImGui::EndDisabled();
        ImGui::EndMenuBar();
    }
    ImGui::End();
}

}  // namespace glint
