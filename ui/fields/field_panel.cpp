#include "ui/fields/field_panel.h"

#include <imgui.h>

#include <algorithm>

#include "ui/widgets/area.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/theme.h"

namespace glint {

namespace {

// Seconds for which a requested field stays marked, and for which it stays marked while waiting for a key.
constexpr double marked_s = 1.5, waits_s = 6;

// Number of ImGui frames from requesting keyboard focus until the text cursor appears.
constexpr int frames_until_typed = 5;

struct AskedField {
    std::string pointer;
    int frames = 0;         // frames since the request: the field is first scrolled to, then focused
    double until = -1;      // ImGui time at which the mark disappears
    std::string component;  // "/1", the component to focus; empty: the first
};
AskedField& asked_field() { return widget_state<AskedField>(); }

bool is_asked_now() { return ImGui::GetTime() < asked_field().until; }

void mark_row(ImVec2 low) {
    const float right = low.x + ImGui::GetContentRegionAvail().x;
    const ImVec2 around{px(5), px(2)}, high{right, ImGui::GetItemRectMax().y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low - 2.0f * around, high + 2.0f * around);  // the labels begin at the panel's edge
    list.AddRect(low - around, high + around, to_u32(theme().accent), px(4), 0, px(1.5f));
    list.PopClipRect();
    redraw_within(std::max(asked_field().until - ImGui::GetTime(), 0.01));
}

/// Draws a switch's key next to it while the switch waits for that key.
void name_its_key(ImVec2 low) {
    constexpr const char* words = "Space: on, off";
    const float right = low.x + ImGui::GetContentRegionAvail().x - px(4);
    const ImVec2 size = ImGui::CalcTextSize(words);
    const float y = (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y - size.y) / 2;
    if (right - size.x < ImGui::GetItemRectMax().x + px(4)) return;
    ImGui::GetWindowDrawList()->AddText({right - size.x, y}, to_u32(theme().dim_text), words);
}

bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); }

bool turns_now(const std::string& pointer) {
    return pointer == asked_field().pointer && is_asked_now() && !ImGui::GetIO().WantTextInput &&
           (is_pressed(ImGuiKey_Space) || is_pressed(ImGuiKey_Enter));
}

}  // namespace

void ask_for_field(const std::string& pointer, const std::string& component) {
    asked_field() = {pointer, 0, ImGui::GetTime() + marked_s, component};
}

bool field_is_asked_below(const std::string& pointer) {
    return is_asked_now() && asked_field().pointer.starts_with(pointer + "/");
}

void draw_asked(const std::string& pointer, Typed typed, const std::function<void()>& draw) {
    AskedField& asked = asked_field();
    if (pointer != asked.pointer || !is_asked_now()) return draw();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (asked.frames < 2) ImGui::SetScrollHereY(0.5f);  // a panel's length is unknown in its first frame
    const bool settles = asked.frames < frames_until_typed;
    if (settles) redraw_within(0);
    if (settles && typed == Typed::Number && !number_in_hand()) type_into(pointer + asked.component);
    if (asked.frames == 1 && typed == Typed::Text) {
        ImGui::SetWindowFocus();
        ImGui::SetKeyboardFocusHere();
    }
    const bool waits = typed == Typed::Key && !ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (waits && asked.frames == 0) asked.until = ImGui::GetTime() + waits_s;
    if (typed == Typed::Key && !waits) asked.until = ImGui::GetTime();
    ++asked.frames;
    draw();
    mark_row(low);
    if (waits) name_its_key(low);
}

void dimmed_unless(bool applies, const std::function<void()>& draw) {
    if (applies) return draw();
    // Does not use ImGuiStyleVar_Alpha, since menus, lists and pickers opened from the field must stay
    // opaque.
    ImVector<ImDrawVert>& vertices = ImGui::GetWindowDrawList()->VtxBuffer;
    const int first = vertices.Size;
    draw();
    for (int i = first; i < vertices.Size; ++i) {
        ImU32& colour = vertices[i].col;
        colour = (colour & ~IM_COL32_A_MASK) | ((colour >> IM_COL32_A_SHIFT) * 3 / 4) << IM_COL32_A_SHIFT;
    }
}

void draw_field(const Row& row, const Switch&, bool& value, bool, const Help& help) {
    if (turns_now(help.pointer)) value = !value;
    switch_field(row.label, value, help);
}

void draw_field(const Row& row, const Vector& kind, glm::vec3& value, const glm::vec3& initial,
                const Help& help) {
    vector_field(row.label, value, component_of(kind), initial, help);
}

void draw_field(const Row& row, const Homogeneous& kind, glm::vec4& value, const glm::vec4& initial,
                const Help& help) {
    glm::vec3 xyz(value);
    vector_field(row.label, xyz, component_of(kind), glm::vec3(initial), help);
    value = {xyz, value.w};
}

void draw_field(const Row& row, const Count& kind, int& value, int initial, const Help& help) {
    int edited = value;
    if (!integer_field(row.label, edited, kind, initial, help)) return;
    // Take the nearest allowed number in the direction of the edit.
    const int step = edited > value ? 1 : -1;
    while (edited >= kind.low && edited <= kind.high && !kind.contains(edited)) edited += step;
    if (kind.contains(edited)) value = edited;
}

}  // namespace glint
