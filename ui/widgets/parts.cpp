#include "ui/widgets/parts.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <sstream>
#include <utility>

#include "models/fields/scene_fields.h"
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

// Fields for choosing from a closed set: a drop-down, or joined buttons.

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
            "Linear red, green and blue; 1 is full, higher values are allowed\nClick: picker and presets · "
            "Drag: onto "
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
