#include "ui/features/lessons/lesson_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/prose.h"
#include "ui/features/plots/plot.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

using Points = std::vector<glm::dvec2>;

std::array<float, 3> channels_of(const Json& colour) {
    std::array<float, 3> channels{0.5f, 0.5f, 0.5f};
    const Json::array_t& list = elements_of(colour);
    for (std::size_t i = 0; i < std::min<std::size_t>(list.size(), 3); ++i)
        channels[i] = std::clamp(static_cast<float>(list[i].get<double>()), 0.0f, 1.0f);
    return channels;
}

/// The drawn values of a sketch; NaN where nothing has been drawn, which draw_curve() leaves out.
Points points_of(const Json& values) {
    Points points;
    const Json::array_t& list = elements_of(values);
    for (std::size_t i = 0; i < list.size(); ++i)
        points.emplace_back(static_cast<double>(i), list[i].is_number()
                                                        ? list[i].get<double>()
                                                        : std::numeric_limits<double>::quiet_NaN());
    return points;
}

/// The upper end of the plot: high enough for the values of any unclipped picture, and for the right values
/// once they may be seen.
double top_of(const Json* right) {
    double top = 1;
    if (right != nullptr)
        for (const Json& v : elements_of(*right)) top = std::max(top, v.get<double>());
    return 1.08 * top;
}

void draw_with_hand(LessonState& lesson, const Prediction& question, const PlotArea& area) {
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return lesson.sketched.reset();
    const ImVec2 hand = ImGui::GetIO().MousePos;
    glm::dvec2 at = area.value(hand);
    at.y = std::clamp(at.y, area.y.low, area.y.high);  // keep the drawn curve visible
    // A stroke that comes this close to an end includes the end.
    const float near_an_end = px(10);
    if (hand.x < area.rect.low.x + near_an_end) at.x = area.x.low;
    if (hand.x > area.rect.high.x - near_an_end) at.x = area.x.high;
    sketch(lesson.chosen, sketch_length(question), lesson.sketched.value_or(at), at);
    lesson.sketched = at;
}

struct OptionColours {
    ImVec4 ground, rim, ink;
};

OptionColours colours_of(OptionLook look, bool hovered) {
    const Theme& t = theme();
    switch (look) {
    case OptionLook::Open:
        return {hovered ? t.field_hovered : t.field, t.line, t.text};
    case OptionLook::Taken:
        return {t.field_active, t.accent, t.text};
    case OptionLook::Right:
    case OptionLook::TakenRight:
        return {t.field, t.accent, t.text};
    case OptionLook::TakenWrong:
        return {t.field, t.warning, t.text};
    case OptionLook::Other:
        return {t.panel, t.line, t.dim_text};
    }
    return {};
}

/// Draws a ring around the option's key, filled if chosen; the right option has a tick.
void option_mark(ImDrawList& list, ImVec2 middle, OptionLook look, const OptionColours& colours,
                 const std::string& letter) {
    const float radius = px(8);
    const ImU32 ink = to_u32(colours.rim);
    list.AddCircle(middle, radius, look == OptionLook::Open ? to_u32(theme().dim_text) : ink, 0, px(1.5f));
    const bool taken =
        look == OptionLook::Taken || look == OptionLook::TakenRight || look == OptionLook::TakenWrong;
    if (taken) list.AddCircleFilled(middle, radius - px(2.5f), ink);
    if (look != OptionLook::Right && look != OptionLook::TakenRight) {
        ImGui::PushFont(fonts().small);
        const ImVec2 low = middle - 0.5f * ImGui::CalcTextSize(letter.c_str());
        list.AddText(low, to_u32(taken ? theme().panel : theme().dim_text), letter.c_str());
        ImGui::PopFont();
        return;
    }
    const ImVec2 foot = middle + ImVec2(px(-1), px(4));
    const ImU32 tick = to_u32(taken ? theme().panel : colours.rim);
    list.AddLine(foot - ImVec2(px(3), px(3)), foot, tick, px(2));
    list.AddLine(foot, foot + ImVec2(px(5), px(-8)), tick, px(2));
}

}  // namespace

std::string letter_of_option(std::size_t index) {
    return std::string(1, static_cast<char>('A' + index % 26));
}

std::optional<std::size_t> option_of_key(KeyPress press, std::size_t options) {
    const auto index = static_cast<std::size_t>(press.key);  // Key::A is 0
    return press.is_alone() && index < options ? std::optional(index) : std::nullopt;
}

std::string answer_text(double value, const std::string& unit) {
    const double rounded = std::abs(value) < 5e-5 ? 0 : value;
    return fmt::format("{:.4g}{}{}", rounded, unit.empty() || unit == "%" ? "" : " ", unit);
}

bool main_button(const char* label, float width) { return chosen_button(label, true, width); }

bool option_card(const std::string& letter, const std::string& text, OptionLook look) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, pad = px(7), left = px(30);
    const float room = std::max(width - left - pad, px(40));
    const float high = prose_height(text, room) + 2 * pad;
    ImGui::PushID(letter.c_str());
    const bool clicked = hit_area("##option", {width, high});
    ImGui::PopID();
    const bool can = look == OptionLook::Open || look == OptionLook::Taken;
    const bool hovered = can && ImGui::IsItemHovered();
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    list_control(text.c_str(), letter, last_item());
    const OptionColours colours = colours_of(look, hovered);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = low + ImVec2(width, high);
    list.AddRectFilled(low, end, to_u32(colours.ground), px(5));
    list.AddRect(low, end, to_u32(colours.rim), px(5), 0, px(look == OptionLook::Open ? 1 : 1.5f));
    option_mark(list, low + ImVec2(px(16), high / 2), look, colours, letter);
    prose_at(list, low + ImVec2(left, pad), room, text, colours.ink);
    return clicked && can;
}

void colour_row(const char* word, const Json& colour) {
    const std::array<float, 3> c = channels_of(colour);
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = px(1) * ImVec2(64, 34);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, low + size, to_u32({c[0], c[1], c[2], 1}), px(4));
    list.AddRect(low, low + size, to_u32(theme().line), px(4));
    ImGui::Dummy(size);
    ImGui::SameLine(0, px(10));
    ImGui::BeginGroup();
    small_dim(word);
    const auto byte = [&c](std::size_t i) { return static_cast<int>(std::lround(255 * c[i])); };
    mono_text(fmt::format("{:3} {:3} {:3}", byte(0), byte(1), byte(2)));
    ImGui::EndGroup();
    list_control(word, "", last_item());
}

bool pick_colour(const char* id, Json& colour) {
    std::array<float, 3> c = channels_of(colour);
    ImGui::SetNextItemWidth(std::min(ImGui::GetContentRegionAvail().x, px(230)));
    const bool touched =
        ImGui::ColorPicker3(id, c.data(),
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_NoLabel);
    list_control("Colour to predict", "", last_item());
    for (float& channel : c) channel = std::clamp(channel, 0.0f, 1.0f);  // larger values can be typed
    if (touched) colour = Json(c);
    return touched;
}

void sketch_plot(LessonState& lesson, const Prediction& question, const Json& mine, const Json* right) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, px(190)};
    (void)hit_area("##sketch", size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Interval x{0, static_cast<double>(sketch_length(question)) - 1}, y{0, top_of(right)};
    const AxisText x_text{"from A to B", "pixels"}, y_text{"intensity", ""};
    const PlotArea area = draw_axes(list, {low, low + size}, x, y, x_text, y_text);
    list_control("Sketch", "", area.rect);
    if (right == nullptr) {
        if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        draw_with_hand(lesson, question, area);
    } else {
        draw_curve(list, area, points_of(*right), theme().accent, 2);
    }
    const Points drawn = points_of(mine);
    if (!drawn.empty()) draw_curve(list, area, drawn, theme().warning, 2);
}

}  // namespace glint
