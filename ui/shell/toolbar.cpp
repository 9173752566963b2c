#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <type_traits>
#include <vector>

#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/fields/field_panel.h"
#include "ui/shell/columns.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws a short label before a switch, vertically centred in the row.
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

/// Returns the width at which a drop-down shows the label completely.
float label_width(const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetFrameHeight();
}

/// Draws all choices side by side if they fit into `room`, else a drop-down. Omits those in `advanced`,
/// unless one of them is chosen.
template <class E>
void choice_switch(const char* name, E& value, const Help& help, float room,
                   std::initializer_list<E> advanced) {
    std::vector<Choice> shown;
    std::vector<E> values;
    for (const E each : enumerators<E>)
        if (each == value || std::find(advanced.begin(), advanced.end(), each) == advanced.end()) {
            shown.push_back(choice_of(each));
            if constexpr (std::is_same_v<E, Reflection>)  // "Phong" is also a shading mode
                if (each == Reflection::Phong) shown.back().label = "Phong model";
            values.push_back(each);
        }
    caption(name);
    int chosen = static_cast<int>(std::find(values.begin(), values.end(), value) - values.begin());
    if (segments_width(shown) <= room) {
        chosen = segments(name, chosen, shown, help);
    } else {
        const float wanted = std::max(label_width(shown[static_cast<std::size_t>(chosen)].label), px(128));
        ImGui::SetNextItemWidth(std::max(std::min(room, wanted), px(40)));
        chosen = drop_down(name, chosen, shown, help);
    }
    value = values[static_cast<std::size_t>(chosen)];
}

/// Draws a round switch with the term's letter in its colour.
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
    tooltip(name, "Switches this term of the equation on or off", on ? "on" : "off", key);
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

/// Draws the undo or redo button. `step` is the name of the step, empty if there is none.
void history_button(UiState& state, CommandId id, Icon icon, const std::string& step) {
    const WindowCommand& row = command(id);
    ImGui::BeginDisabled(!can_run(state, row));
    if (icon_button(row.name, icon)) run_command(state, row);
    ImGui::EndDisabled();
    tooltip(row.name, can_run(state, row) ? step.c_str() : why_disabled(state, row).c_str(), "",
            keys_of(row));
}

/// Draws the undo and redo buttons.
void history_buttons(UiState& state) {
    history_button(state, CommandId::Undo, Icon::Undo, state.editor.history.undo_name());
    ImGui::SameLine(0, px(2));
    history_button(state, CommandId::Redo, Icon::Redo, state.editor.history.redo_name());
}

float caption_width(const char* text) {
    return fonts().small->CalcTextSizeA(small_text_height(), 1e9f, 0, text).x + px(6);
}

/// Draws the controls to the right of the menus. Those that do not fit are behind "»".
void switches(UiState& state, const Rect& area) {
    Shading& shading = state.editor.scene().shading;
    const float button = ImGui::GetFrameHeight(), gap = px(area.size().x > px(three_column_width) ? 16 : 8);
    const float terms = 4 * button + 3 * px(3), history = 2 * button + px(2), right_end = area.high.x - px(8);
    const float y = area.low.y + (area.size().y - button) / 2, more = px(26), combo = px(128);
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x + gap, y});
    const float captions = caption_width("Shading") + caption_width("Reflection");
    const float all = right_end - ImGui::GetCursorScreenPos().x - captions - 3 * gap;  // without the captions
    const bool fits = all >= 2 * combo + terms + history;
    const float choices_room = all - (fits ? terms + history : more);
    const float of_mode = segments_width(choices<ShadingMode>);
    // If there is not enough room for the two labels, one that would be cut off gets the space that the other
    // does not need.
    const float half = choices_room / 2, least = label_width(choice_of(shading.mode).label);
    const float left = choices_room - label_width(choice_of(shading.reflection).label);
    const float mode_room =
        choices_room >= of_mode + combo ? of_mode : std::min(half, std::max(left, std::min(least, half)));
    choice_switch("Shading", shading.mode, {"Where the lighting equation is evaluated", "/shading/mode"},
                  mode_room, {});
    ImGui::SameLine(0, gap);
    choice_switch("Reflection", shading.reflection,
                  {"How surfaces reflect light, unless a material has its own model", "/shading/reflection"},
                  choices_room - std::min(mode_room, std::max(of_mode, combo)), {Reflection::Retro});
    ImGui::SameLine(0, gap);
    if (fits) {
        term_switches(shading.terms);
        ImGui::SetCursorScreenPos({right_end - history, y});
        return history_buttons(state);
    }
    ImGui::SetCursorScreenPos({right_end - more, y});
    overflow("##top", HUGE_VALF, [&] {
        term_switches(shading.terms);
        ImGui::SameLine(0, px(10));
        history_buttons(state);
    });
}

}  // namespace

void toolbar(UiState& state, const Rect& area) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    const float line = ImGui::GetFontSize();
    // ImGui makes the menu bar one frame high, so padding makes it fill the row.
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
