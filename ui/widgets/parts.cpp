#include "ui/widgets/parts.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws a button, in the colours of a chosen one if `chosen`.
template <class Button> bool with_choice(bool chosen, const Button& button) {
    const Theme& t = theme();
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? t.accent : t.field);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, chosen ? accent_pointed_at(t, false) : t.field_hovered);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, chosen ? accent_pointed_at(t, true) : t.field_active);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? t.accent_text : t.text);
    const bool clicked = button();
    ImGui::PopStyleColor(4);
    return clicked;
}

/// Breaks text between words if it is longer than a line of `width`. ImGui would also break after a decimal
/// point.
std::string in_lines(const std::string& text, float width) {
    std::string lines, line;
    const auto end_line = [&] { lines += (lines.empty() ? "" : "\n") + std::exchange(line, {}); };
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ' ');) {
        std::string longer = line;
        if (!longer.empty()) longer += ' ';
        longer += word;
        const bool fits = ImGui::CalcTextSize(longer.c_str()).x <= width;
        if (!fits && !line.empty()) end_line();
        line = line.empty() ? word : longer;
    }
    end_line();
    return lines;
}

/// Draws wrapped text as ImGui does, but breaks it by in_lines().
void wrapped(const ImVec4& colour, const std::string& text) {
    ImGui::PushTextWrapPos(0);  // in case a word is longer than a line
    coloured(colour, in_lines(text, ImGui::GetContentRegionAvail().x));
    ImGui::PopTextWrapPos();
}

bool nothing_dragged() { return !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive(); }

}  // namespace

void cut_text(ImDrawList& list, ImVec2 low, float right, std::string_view text) {
    const char *const begin = text.data(), *const end = begin + text.size();
    ImGui::RenderTextEllipsis(&list, low, {right, low.y + ImGui::GetTextLineHeight()}, right, right, begin,
                              end, nullptr);
}

void coloured(const ImVec4& colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

void coloured(Symbol symbol, const std::string& text) { coloured(theme()[symbol], text); }

void light_icon(const Light& light) {
    const float line = ImGui::GetTextLineHeight();
    draw_icon(*ImGui::GetWindowDrawList(), icon_of(light.kind),
              ImGui::GetCursorScreenPos() + line / 2 * ImVec2(1, 1), line, to_u32(legible(colour_of(light))));
}

void legend(std::initializer_list<std::pair<Symbol, std::string>> words) {
    for (const auto& each : words) {
        if (&each != words.begin()) ImGui::SameLine(0, px(8));
        coloured(each.first, each.second);
    }
}

void warning_text(const std::string& text) { wrapped(theme().warning, text); }

void wrapped_dim(const std::string& text) { wrapped(theme().dim_text, text); }

void small_dim(const std::string& text) {
    ImGui::PushFont(fonts().small);
    wrapped_dim(text);
    ImGui::PopFont();
}

bool chosen_button(const char* label, bool chosen, float width) {
    return with_choice(chosen, [=] { return ImGui::Button(label, {width, 0}); });
}

ImVec2 small_padding() { return {px(6), std::max((px(24) - ImGui::GetTextLineHeight()) / 2, px(1))}; }

bool small_button(const char* label) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, small_padding());
    const bool clicked = ImGui::Button(label);
    ImGui::PopStyleVar();
    return clicked;
}

bool small_chosen_button(const char* label, bool chosen) {
    return with_choice(chosen, [label] { return small_button(label); });
}

bool light_combo(const char* id, int& light, const std::vector<Light>& lights) {
    const int count = static_cast<int>(lights.size());
    light = std::clamp(light, 0, count - 1);
    const auto name = [&](int i) { return whole_label(lights[static_cast<std::size_t>(i)].name); };
    if (!ImGui::BeginCombo(id, name(light).c_str())) return true;
    for (int i = 0; i < count; ++i) {
        ImGui::PushID(i);
        if (ImGui::Selectable(name(i).c_str(), i == light)) light = i;
        ImGui::PopID();
    }
    ImGui::EndCombo();
    return false;
}

void overflow(const char* id, float width, const std::function<void()>& draw) {
    if (width <= ImGui::GetContentRegionAvail().x) return draw();
    ImGui::PushID(id);
    const bool is_small = ImGui::GetFont() == fonts().small;
    if (is_small ? small_button("»") : ImGui::Button("»")) ImGui::OpenPopup("##more");
    tooltip("More", "Controls that do not fit");
    if (ImGui::BeginPopup("##more")) {
        draw();
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

void same_line_if_fits(float width, float gap, float right) {
    if (ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine(0, gap);
}

bool is_pointed_at() { return ImGui::IsItemHovered() && nothing_dragged(); }

bool is_pointed_at(const Rect& area) {
    constexpr bool clipped = false;  // a table row is wider than the cell drawn last
    return ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(area.low, area.high, clipped) &&
           nothing_dragged();
}

ImU32 rim_colour(float opacity) { return to_u32({0, 0, 0, 1}, 0.6f * opacity); }

void cased_line(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 colour, float width, float opacity) {
    list.AddLine(a, b, rim_colour(opacity), px(width + rim_width));
    list.AddLine(a, b, colour, px(width));
}

void cased_circle(ImDrawList& list, ImVec2 middle, float radius, ImU32 colour, float width) {
    list.AddCircle(middle, px(radius), rim_colour(), 0, px(width + rim_width));
    list.AddCircle(middle, px(radius), colour, 0, px(width));
}

void cased_outline(ImDrawList& list, const std::vector<ImVec2>& corners, ImU32 colour, float width,
                   bool closed) {
    const int count = static_cast<int>(corners.size());
    const ImDrawFlags flags = closed ? ImDrawFlags_Closed : ImDrawFlags_None;
    list.AddPolyline(corners.data(), count, rim_colour(), flags, px(width + rim_width));
    list.AddPolyline(corners.data(), count, colour, flags, px(width));
}

void rimmed_disc(ImDrawList& list, ImVec2 middle, float radius, ImU32 colour, float opacity) {
    list.AddCircleFilled(middle, px(radius + 1.5f), rim_colour(opacity));
    list.AddCircleFilled(middle, px(radius), colour);
}

void arrow_head(ImDrawList& list, ImVec2 tip, ImVec2 way, float length, float half_width, ImU32 colour) {
    const ImVec2 neck = tip - px(length) * way, aside = px(half_width) * ImVec2(-way.y, way.x);
    list.AddTriangleFilled(tip, neck + aside, neck - aside, colour);
}

void rimmed_text(ImDrawList& list, ImVec2 middle, const ImVec4& colour, const std::string& text) {
    const ImVec2 low = middle - ImGui::CalcTextSize(text.c_str()) / 2;
    const ImVec2 at{std::round(low.x), std::round(low.y)};
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            list.AddText(at + px(1) * ImVec2(float(x), float(y)), rim_colour(), text.c_str());
    list.AddText(at, to_u32(colour), text.c_str());
}

void badge_ground(ImDrawList& list, const Rect& area, bool lit) {
    list.AddRectFilled(area.low, area.high, to_u32(lit ? theme().field_active : theme().window, 0.88f),
                       px(6));
}

Rect badge(ImDrawList& list, ImVec2 at, const std::string& text, ImVec2 pivot) {
    const ImVec2 pad = px(1) * ImVec2(8, 5), size = ImGui::CalcTextSize(text.c_str()) + 2 * pad;
    const ImVec2 low = at - ImVec2(pivot.x * size.x, pivot.y * size.y);
    badge_ground(list, {low, low + size});
    list.AddText(low + pad, to_u32(theme().text), text.c_str());
    return {low, low + size};
}

bool fold(const char* title, bool open_at_first, bool opens) {
    ImGui::PushID(title);
    bool* const open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("##open"), open_at_first);
    *open |= opens;
    const float width = ImGui::GetContentRegionAvail().x, words_width = std::max(width - px(14), 1.0f);
    const float height = ImGui::CalcTextSize(title, nullptr, true, words_width).y + px(6);
    if (hit_area("##fold", {width, height})) *open = !*open;
    const Rect row = last_item();
    list_control(title, "", row);
    const ImVec4& ink = ImGui::IsItemHovered() ? theme().text : theme().dim_text;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 middle{row.low.x + px(5), row.low.y + px(3) + ImGui::GetTextLineHeight() / 2};
    const float r = px(4);
    if (*open)
        list.AddTriangleFilled(middle + ImVec2(-r, -r / 2), middle + ImVec2(r, -r / 2),
                               middle + ImVec2(0, r * 0.7f), to_u32(ink));
    else
        list.AddTriangleFilled(middle + ImVec2(-r / 2, -r), middle + ImVec2(r * 0.7f, 0),
                               middle + ImVec2(-r / 2, r), to_u32(ink));
    list.AddText(nullptr, 0, {row.low.x + px(14), row.low.y + px(3)}, to_u32(ink), title,
                 ImGui::FindRenderedTextEnd(title), words_width);
    ImGui::PopID();
    return *open;
}

}  // namespace glint
