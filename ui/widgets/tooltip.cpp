// What a control says of itself: to the pointer that rests on it, and to tests.
#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <limits>

#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double rest_before_tooltip = 0.45;  // seconds

// Kept from frame to frame, as ui/ui.h says.
double earliest_redraw = std::numeric_limits<double>::infinity();
ImVec2 resting_on;  // the item under the pointer
double resting_since = 0;
std::vector<NamedControl>* listed = nullptr;

}  // namespace

void redraw_within(double seconds) { earliest_redraw = std::min(earliest_redraw, seconds); }
void reset_next_redraw() { earliest_redraw = std::numeric_limits<double>::infinity(); }
double next_redraw() { return earliest_redraw; }

void tooltip(const char* title, const char* what, const std::string& range, const std::string& key) {
    list_control(title, key, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsAnyMouseDown()) return;
    const ImVec2 item = ImGui::GetItemRectMin();
    if (item.x != resting_on.x || item.y != resting_on.y) {
        resting_on = item;
        resting_since = ImGui::GetTime();
    }
    const double rested = ImGui::GetTime() - resting_since;
    if (rested < rest_before_tooltip) return redraw_within(rest_before_tooltip - rested + 0.01);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10), px(8)});
    ImGui::PushStyleColor(ImGuiCol_Text, theme().text);  // whatever colour the item's own text has
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(px(320));
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
    if (!key.empty()) dim_text(key.c_str());
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

void list_controls_in(std::vector<NamedControl>* list) { listed = list; }

void list_control(const char* name, const std::string& key, const Rect& at) {
    if (listed == nullptr) return;
    listed->push_back({name, key, keys_of_value(key), at, ImGui::IsRectVisible(at.low, at.high)});
}

}  // namespace glint
