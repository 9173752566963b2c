// Fields for choosing from a closed set: a drop-down, or joined buttons.

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "models/fields/scene_fields.h"
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

/// Returns the space on either side of a segment's label; less if the row is too narrow for all labels.
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

/// Draws a segment; true when pressed.
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
    // Labels that do not fit use a smaller font instead of being cut off.
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

// A colour field: three numbers, and a swatch that opens a picker and the presets.

namespace {

constexpr ImGuiColorEditFlags as_numbers = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR |
                                           ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoOptions;
constexpr std::size_t presets_a_row = 10;

bool swatch(const char* id, glm::vec3 colour, float side) {
    const bool pressed = ImGui::ColorButton(id, {colour.x, colour.y, colour.z, 1},
                                            as_numbers | ImGuiColorEditFlags_NoTooltip, {side, side});
    // The frame is white on a light panel, black on a dark one.
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        to_u32(theme().dim_text, 0.6f), ImGui::GetStyle().FrameRounding);
    return pressed;
}

/// Accepts the colour of a swatch that was dragged here from another field.
void take_dropped_colour(glm::vec3& value) {
    if (!ImGui::BeginDragDropTarget()) return;
    const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(IMGUI_PAYLOAD_TYPE_COLOR_3F);
    if (payload != nullptr) std::copy_n(static_cast<const float*>(payload->Data), 3, &value.x);
    ImGui::EndDragDropTarget();
}

void presets(glm::vec3& value, float width) {
    const auto all = colour_presets();
    const float gap = px(4);
    const float side = (width - gap * float(presets_a_row - 1)) / float(presets_a_row);
    for (std::size_t i = 0, column = 0; i < all.size(); ++i, ++column) {
        const bool lamps_begin = i > 0 && all[i].kelvin > 0 && all[i - 1].kelvin == 0;
        if (lamps_begin) column = 0;
        if (column % presets_a_row != 0) ImGui::SameLine(0, gap);
        if (swatch(fmt::format("##preset{}", i).c_str(), all[i].linear, side)) value = all[i].linear;
        const glm::vec3 c = all[i].linear;
        const std::string kelvin =
            all[i].kelvin > 0 ? fmt::format("Like a black body at {} K", all[i].kelvin) : "";
        tooltip(all[i].name, kelvin.c_str(), fmt::format("{:.3g}  {:.3g}  {:.3g}", c.x, c.y, c.z));
    }
}

/// Draws the picker with the presets below it, next to the swatch that opened it.
void picker(const char* label, glm::vec3& value) {
    if (!ImGui::BeginPopup("##colour")) return;
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted(label, ImGui::FindRenderedTextEnd(label));
    ImGui::PopFont();
    const float width = px(236);
    ImGui::SetNextItemWidth(width);
    ImGui::PushFont(fonts().figures);
    ImGui::ColorPicker3("##picker", &value.x,
                        as_numbers | ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                            ImGuiColorEditFlags_NoInputs);
    ImGui::PopFont();
    section_heading("Presets");
    presets(value, width);
    ImGui::EndPopup();
}

}  // namespace

void colour_field(const char* label, glm::vec3& value, glm::vec3 initial, const Help& help) {
    ImGui::PushID(label);
    const float gap = px(3), side = ImGui::GetFrameHeight();
    const float width = (label_cell(label) - side - 3 * gap) / 3;
    for (int i = 0; i < 3; ++i) {
        constexpr std::array channels{"red", "green", "blue"};
        bare_number(fmt::format("{}: {}", label, channels[static_cast<std::size_t>(i)]).c_str(), value[i],
                    channel_field, initial[i], {help.what, help.pointer + "/" + std::to_string(i)}, width);
        ImGui::SameLine(0, gap);
    }
    glm::vec3 picked = value;
    if (swatch("##swatch", value, side)) ImGui::OpenPopup("##colour");
    const ImVec2 beside{ImGui::GetItemRectMax().x + px(6), ImGui::GetItemRectMin().y};
    tooltip(label, help.what,
            "Linear red, green and blue; 1 is full, more is allowed\nClick: picker and presets · Drag: onto "
            "another swatch",
            help.pointer);
    take_dropped_colour(picked);
    ImGui::SetNextWindowPos(beside, ImGuiCond_Appearing);
    picker(label, picked);
    if (picked != value) value = glm::clamp(picked, glm::vec3(0), glm::vec3(float(max_number)));
    ImGui::PopID();
}

std::span<const ColourPreset> colour_presets() {
    // Lamps: Planck's law with the colour matching functions of CIE 1931 (Wyman, Sloan, Shirley 2013),
    // converted to linear sRGB, clamped at 0 and divided by the largest channel.
    static constexpr std::array all{ColourPreset{"White", {1, 1, 1}},
                                    ColourPreset{"Half grey", {0.5f, 0.5f, 0.5f}},
                                    ColourPreset{"Middle grey, 18 %", {0.18f, 0.18f, 0.18f}},
                                    ColourPreset{"Black", {0, 0, 0}},
                                    ColourPreset{"Red", {1, 0, 0}},
                                    ColourPreset{"Yellow", {1, 1, 0}},
                                    ColourPreset{"Green", {0, 1, 0}},
                                    ColourPreset{"Cyan", {0, 1, 1}},
                                    ColourPreset{"Blue", {0, 0, 1}},
                                    ColourPreset{"Magenta", {1, 0, 1}},
                                    ColourPreset{"Candle", {1, 0.242f, 0}, 1900},
                                    ColourPreset{"Incandescent lamp", {1, 0.423f, 0.1f}, 2700},
                                    ColourPreset{"Halogen lamp", {1, 0.522f, 0.195f}, 3200},
                                    ColourPreset{"Moonlight", {1, 0.674f, 0.403f}, 4100},
                                    ColourPreset{"Sun at noon", {1, 0.852f, 0.755f}, 5500},
                                    ColourPreset{"Overcast sky", {1, 0.944f, 0.993f}, 6500},
                                    ColourPreset{"Blue sky", {0.61f, 0.695f, 1}, 10'000}};
    return all;
}

}  // namespace glint
