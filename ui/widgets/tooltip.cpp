// Describes a control, to the user in a tooltip and to tests by name.
#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ui/widgets/kept.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double rest_before_tooltip = 0.45;  // seconds

/// The item under the pointer.
struct Resting {
    ImGuiID item = 0;  // 0: `at` identifies the item
    ImVec2 at;
    double since = 0;
    int frame = -1;        // the last frame in which the pointer was on it
    bool clicked = false;  // the user knows the item, so there is no tooltip until the pointer has left it
};
struct ControlsState {
    double earliest_redraw = std::numeric_limits<double>::infinity();
    Resting resting;
    /// Where a click silenced tooltips, so that until the pointer moves they do not cover what the click
    /// opened.
    std::optional<ImVec2> silenced;
    std::vector<NamedControl>* listed = nullptr;
};
ControlsState& controls() { return widget_state<ControlsState>(); }

/// Whether text is being typed in another window, such as the list of actions, which a tooltip would cover.
bool types_elsewhere() {
    const ImGuiWindow* const typed = GImGui->ActiveIdWindow;
    return ImGui::GetIO().WantTextInput && GImGui->ActiveId != 0 && typed != nullptr &&
           typed->RootWindow != ImGui::GetCurrentWindow()->RootWindow;
}

void follow_clicks() {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::optional<ImVec2>& silenced = controls().silenced;
    if (ImGui::IsAnyMouseDown())
        silenced = mouse;
    else if (silenced && std::abs(mouse.x - silenced->x) + std::abs(mouse.y - silenced->y) > px(4))
        silenced.reset();
}

/// Tracks the pointer on the item drawn last. True once the pointer has hovered long enough for a tooltip.
bool is_due() {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return false;
    const ImGuiID item = GImGui->LastItemData.ID;
    const ImVec2 at = ImGui::GetItemRectMin();
    const int frame = ImGui::GetFrameCount();
    Resting& resting = controls().resting;
    const bool same = item == resting.item && (item != 0 || (at.x == resting.at.x && at.y == resting.at.y));
    if (!same || frame > resting.frame + 1) resting = {item, at, ImGui::GetTime(), frame, false};
    resting.frame = frame;
    if (ImGui::IsAnyMouseDown()) resting.clicked = true;
    if (resting.clicked || controls().silenced || types_elsewhere()) return false;
    const double rested = ImGui::GetTime() - resting.since;
    if (rested < rest_before_tooltip) redraw_within(rest_before_tooltip - rested + 0.01);
    return rested >= rest_before_tooltip;
}

/// Positions the next tooltip and returns the width of its lines. In a column it stays within the column,
/// below or above its item, so that it does not cover the picture; elsewhere it is next to the pointer.
float place_tooltip() {
    constexpr float usual = 320, least = 180;
    const ImGuiWindow& part = *ImGui::GetCurrentWindow()->RootWindow;
    const float room = part.Size.x - 2 * px(8) - 2 * px(10);
    const bool column =
        part.Size.y > part.Size.x && room >= px(least) && part.Size.x < ImGui::GetIO().DisplaySize.x / 2;
    if (!column) return px(usual);
    const Rect item = last_item();
    const bool above = item.high.y > 0.7f * ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowPos({part.Pos.x + px(8), above ? item.low.y - px(6) : item.high.y + px(6)},
                            ImGuiCond_Always, {0, above ? 1.0f : 0.0f});
    return std::min(px(usual), room);
}

}  // namespace

std::string whole_label(const std::string& name) {
    std::string label;
    for (const char c : name) {
        // A carriage return counts as a letter in the search for "##", and is not drawn.
        if (c == '#' && !label.empty() && label.back() == '#') label += '\r';
        label += breaks_line(c) ? ' ' : c;
    }
    return label;
}

void redraw_within(double seconds) {
    controls().earliest_redraw = std::min(controls().earliest_redraw, seconds);
}
void reset_next_redraw() { controls().earliest_redraw = std::numeric_limits<double>::infinity(); }
double next_redraw() { return controls().earliest_redraw; }

void tooltip(const char* title, const char* what, const std::string& range, const std::string& key) {
    list_control(title, key, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    follow_clicks();
    if (!is_due()) return;
    const float width = place_tooltip();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10), px(8)});
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0f);      // a disabled item is translucent
    ImGui::PushStyleColor(ImGuiCol_Text, theme().text);  // regardless of the item's own colour
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(width);
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted(title, ImGui::FindRenderedTextEnd(title));
    ImGui::PopFont();
    const std::string keys = keys_of_value(key);
    if (!keys.empty())
        ImGui::TextUnformatted(fmt::format("{} (key {})", what, keys).c_str());
    else if (*what != 0)
        ImGui::TextUnformatted(what);
    ImGui::PushFont(fonts().small);
    if (!range.empty()) dim_text(range.c_str());
    if (!key.empty() && ImGui::GetIO().KeyAlt) dim_text(key.c_str());  // for users who edit scene files
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

void list_controls_in(std::vector<NamedControl>* list) { controls().listed = list; }

void list_control(const char* name, const std::string& key, const Rect& at) {
    if (controls().listed == nullptr) return;
    controls().listed->push_back({name, key, keys_of_value(key), at, ImGui::IsRectVisible(at.low, at.high)});
}

}  // namespace glint
