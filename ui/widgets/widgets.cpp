#include "ui/widgets/widgets.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "models/saturate.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

/// The ends of a range as floats that are in it.
float lowest(const Range& range) {
    const auto low = static_cast<float>(range.low);
    return range.low_open ? std::nextafter(low, static_cast<float>(range.high)) : low;
}
float highest(const Range& range) {
    const auto high = static_cast<float>(range.high);
    return range.high_open ? std::nextafter(high, static_cast<float>(range.low)) : high;
}

std::string range_text(const Real& kind, float initial) {
    const Range& range = kind.range;
    const auto shown = [&kind](float v) {
        return fmt::format("{:.6g}{}{}", v, *kind.unit != 0 ? " " : "", kind.unit);
    };
    std::string text = kind.unit;
    if (range.low > -max_number && range.high < max_number)
        text = fmt::format("{}{}{}", range.words, *kind.unit != 0 ? " " : "", kind.unit);
    else if (range.low > -max_number)
        text = range.low_open ? fmt::format("above {:.6g}", range.low)
                              : fmt::format("{:.6g} and above", range.low);
    return fmt::format("{}{}default {}", text, text.empty() ? "" : ", ", shown(initial));
}

/// The bar behind a number that says how much of its usual range it takes.
void share_bar(float value, const Real& kind, ImVec2 low, float width) {
    const float first = lowest(kind.range), range = kind.usual_max - first;
    if (kind.usual_max <= 0 || range <= 0 || kind.range.low <= -max_number) return;
    float share = (value - first) / range;
    if (kind.logarithmic && kind.usual_max > 1) share = std::log1p(value - first) / std::log1p(range);
    share = std::clamp(share, 0.0f, 1.0f);
    if (share * width < 1) return;
    const float height = ImGui::GetFrameHeight();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + share * width, low.y + height},
                                              to_u32(theme().accent, 0.32f), ImGui::GetStyle().FrameRounding);
}

/// The bare draggable number, `width` wide. Double-click and right-click return to the default.
bool drag_number(const char* id, float& value, const Real& kind, float initial, float width) {
    ImGuiIO& io = ImGui::GetIO();
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + width, low.y + ImGui::GetFrameHeight()};
    const bool inside = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high);
    const bool reset = inside && (io.MouseDoubleClicked[0] || io.MouseClicked[1]) && !io.KeyCtrl &&
                       !(GImGui->CurrentItemFlags & ImGuiItemFlags_Disabled);
    const bool double_clicked = io.MouseDoubleClicked[0];
    if (reset) io.MouseDoubleClicked[0] = false;  // ImGui would open its text entry
    float edited = value;
    const float scale = kind.logarithmic ? std::max(std::abs(value), kind.step * 10) : 1;
    // ImGui makes drags with Shift ten times faster; here they are ten times finer.
    const float speed = kind.step * scale * (io.KeyShift ? 0.01f : 1.0f);
    const float least = lowest(kind.range), most = highest(kind.range);
    ImGui::PushFont(fonts().figures);
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(4), ImGui::GetStyle().FramePadding.y});
    bool changed =
        ImGui::DragFloat(id, &edited, speed, least, most, kind.format, ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    io.MouseDoubleClicked[0] = double_clicked;
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (reset) {
        ImGui::ClearActiveID();
        changed = value != initial;
        edited = initial;
    }
    if (changed && std::isfinite(edited)) value = std::clamp(edited, least, most);
    return changed;
}

void number_tooltip(const char* label, const Real& kind, float initial, const Help& help) {
    tooltip(label, help.what,
            range_text(kind, initial) + "\nDrag · Shift: fine · Ctrl+click: type · double-click: default",
            help.pointer);
}

}  // namespace

bool hit_area(const char* id, ImVec2 size, ImGuiButtonFlags flags) {
    return ImGui::InvisibleButton(id, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)}, flags);
}

float label_cell(const char* label) {
    const float label_width = px(88);
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, theme().dim_text);
    ImGui::TextUnformatted(label, ImGui::FindRenderedTextEnd(label));
    ImGui::PopStyleColor();
    ImGui::SameLine(left + label_width, 0);
    return ImGui::GetContentRegionAvail().x;
}

bool number_field(const char* label, float& value, const Real& kind, float initial, const Help& help) {
    ImGui::PushID(label);
    const float width = label_cell(label);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool changed = drag_number("##number", value, kind, initial, width);
    share_bar(value, kind, low, width);
    number_tooltip(label, kind, initial, help);
    ImGui::PopID();
    return changed;
}

bool bare_number(const char* label, float& value, const Real& kind, float initial, const Help& help,
                 float width) {
    ImGui::PushID(label);
    const bool changed = drag_number("##number", value, kind, initial, width);
    number_tooltip(label, kind, initial, help);
    ImGui::PopID();
    return changed;
}

bool integer_field(const char* label, int& value, int low, int high, int initial, const Help& help) {
    const std::string words = fmt::format("{} to {}", low, high);
    // A drag over 300 pixels goes from the default to four times the default, whatever the limit is.
    const Real kind{.range = {double(low), double(high), words},
                    .step = std::max(0.03f, float(initial) / 100),
                    .format = "%.0f",
                    .usual_max = high <= 64 ? float(high) : 0};
    float real = float(value);
    if (!number_field(label, real, kind, float(initial), help)) return false;
    const int whole = std::clamp(saturated_int(std::round(real)), low, high);
    const bool changed = whole != value;
    value = whole;
    return changed;
}

bool vector_field(const char* label, glm::vec3& value, const Real& kind, glm::vec3 initial,
                  const Help& help) {
    ImGui::PushID(label);
    const float gap = px(3), width = (label_cell(label) - 2 * gap) / 3;
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
        ImGui::PushID(i);
        if (i > 0) ImGui::SameLine(0, gap);
        changed |= drag_number("##part", value[i], kind, initial[i], width);
        const char* const names[] = {"x", "y", "z"};
        number_tooltip(fmt::format("{} {}", label, names[i]).c_str(), kind, initial[i],
                       {help.what, help.pointer + "/" + std::to_string(i)});
        ImGui::PopID();
    }
    ImGui::PopID();
    return changed;
}

bool switch_field(const char* label, bool& value, const Help& help) {
    ImGui::PushID(label);
    label_cell(label);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(2), px(2)});
    const bool changed = ImGui::Checkbox("##switch", &value);
    ImGui::PopStyleVar();
    tooltip(label, help.what, "", help.pointer);
    ImGui::PopID();
    return changed;
}

bool name_field(const char* label, std::string& name, const Help& help) {
    ImGui::PushID(label);
    ImGui::SetNextItemWidth(label_cell(label));
    const bool changed = ImGui::InputText("##name", &name);
    tooltip(label, help.what, "", help.pointer);
    ImGui::PopID();
    return changed;
}

void section_heading(const char* title) {
    ImGui::Dummy({0, px(3)});
    ImGui::PushFont(fonts().small);
    dim_text(title);
    ImGui::PopFont();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float y = (low.y + high.y) / 2, right = low.x + ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddLine({high.x + px(6), y}, {right, y}, to_u32(theme().line));
}

void dim_text(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme().dim_text);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

std::string with_thousands(std::uint64_t n) {
    std::string digits = std::to_string(n);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ' ');
    return digits;
}

void mono_text(const std::string& text) {
    ImGui::PushFont(fonts().figures);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
}

}  // namespace glint
