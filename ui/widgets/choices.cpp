// A choice from a closed set: as a drop-down, or as joined buttons.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

void option_tooltip(const Choice& option, const Help& help) {
    const std::string key = help.pointer.empty() ? "" : fmt::format("{} = \"{}\"", help.pointer, option.word);
    tooltip(option.label, option.meaning, "", key);
}

float segment_width(const Choice& option, float padding) {
    return ImGui::CalcTextSize(option.label).x + 2 * padding;
}

/// Space on either side of a segment's label; less if the row is too narrow for all labels.
float segment_padding(std::span<const Choice> options) {
    const float wanted = segments_width(options), room = ImGui::GetContentRegionAvail().x;
    const float missing = std::max(wanted - room, 0.0f) / (2 * static_cast<float>(options.size()));
    return std::max(px(8) - missing, px(2));
}

/// The style of one of the joined buttons: only outer corners are rounded.
struct Segment {
    bool on;
    ImDrawFlags corners;
    float padding;
};

/// Draws a segment. True when pressed.
bool segment(const Choice& option, const Segment& look) {
    const auto [on, corners, padding] = look;
    const bool pressed = hit_area("##segment", {segment_width(option, padding), ImGui::GetFrameHeight()});
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const Theme& t = theme();
    const bool pointed_at = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
    const ImVec4 chosen = pointed_at ? accent_pointed_at(t, held) : t.accent;
    const ImVec4 fill = on ? chosen : pointed_at ? t.field_hovered : t.field;
    const ImVec4& ink = on ? t.accent_text : t.text;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, to_u32(fill), ImGui::GetStyle().FrameRounding, corners);
    list.AddText({low.x + padding, low.y + ImGui::GetStyle().FramePadding.y}, to_u32(ink), option.label);
    return pressed;
}

}  // namespace

int drop_down(const char* label, int chosen, std::span<const Choice> options, const Help& help) {
    ImGui::PushID(label);
    int result = chosen;
    const Choice& present = options[static_cast<std::size_t>(chosen)];
    if (ImGui::BeginCombo("##choice", present.label)) {
        for (int i = 0; i < static_cast<int>(options.size()); ++i) {
            const Choice& option = options[static_cast<std::size_t>(i)];
            if (ImGui::Selectable(option.label, i == chosen)) result = i;
            option_tooltip(option, help);
        }
        ImGui::EndCombo();
    } else {
        tooltip(label, help.what, present.meaning, help.pointer);
    }
    ImGui::PopID();
    return result;
}

int choose(const char* label, int chosen, std::span<const Choice> options, const Help& help) {
    ImGui::SetNextItemWidth(label_cell(label));
    return drop_down(label, chosen, options, help);
}

float segments_width(std::span<const Choice> options) {
    float width = 0;
    for (const Choice& option : options) width += segment_width(option, px(8)) + px(1);
    return width;
}

int segments(const char* id, int chosen, std::span<const Choice> options, const Help& help) {
    ImGui::PushID(id);
    int result = chosen;
    // If the labels do not fit, they use a smaller font instead of being cut off.
    const bool crowded = segment_padding(options) < px(4);
    if (crowded) ImGui::PushFont(fonts().small);
    const float padding = segment_padding(options);
    for (int i = 0; i < static_cast<int>(options.size()); ++i) {
        ImGui::PushID(i);  // labels may be empty
        const Choice& option = options[static_cast<std::size_t>(i)];
        const bool first = i == 0, last = i + 1 == static_cast<int>(options.size());
        if (!first) ImGui::SameLine(0, px(1));
        const ImDrawFlags corners = first  ? ImDrawFlags_RoundCornersLeft
                                    : last ? ImDrawFlags_RoundCornersRight
                                           : ImDrawFlags_RoundCornersNone;
        if (segment(option, {i == chosen, corners, padding})) result = i;
        option_tooltip(option, help);
        ImGui::PopID();
    }
    if (crowded) ImGui::PopFont();
    ImGui::PopID();
    return result;
}

}  // namespace glint
