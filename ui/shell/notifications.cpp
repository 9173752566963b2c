#include "ui/shell/notifications.h"

#include <imgui_internal.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "models/utf8.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double seconds_over_dialog = 10;
constexpr double seconds_to_read = 2;      // minimum time for an error before another message may replace it
constexpr int frames_to_come_back = 3;     // until a dialog reopens after a file dialog
constexpr std::size_t longest_text = 480;  // bytes: about nine lines

double seconds_shown(Tone tone) {
    switch (tone) {
    case Tone::Done:
        return 3;
    case Tone::Warning:
        return 10;
    case Tone::Error:
        return std::numeric_limits<double>::infinity();
    }
    return 3;  // not reached
}

const ImVec4& ink(Tone tone) {
    return tone == Tone::Error ? theme().error : tone == Tone::Warning ? theme().warning : theme().accent;
}

/// Cuts the middle out of a long text: its beginning says where the problem is, its end what was expected.
std::string without_middle(const std::string& text) {
    if (text.size() <= longest_text) return text;
    std::size_t head = longest_text * 2 / 3, tail = text.size() - longest_text / 3;
    while (continues_character(text[head])) --head;
    while (tail < text.size() && continues_character(text[tail])) ++tail;
    return text.substr(0, head) + " … " + text.substr(tail);
}

/// Draws the notification upwards from `low_right` to at most `top`. If the text is taller, it scrolls with
/// the wheel and the close button stays visible. True when it is closed; `pressed`: by its own button.
bool draw_one(const Notification& note, bool& pressed, ImVec2 low_right, float top, float width) {
    ImGui::SetNextWindowPos(low_right, ImGuiCond_Always, {1, 1});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(low_right.y - top, px(40))});
    ImGui::SetNextWindowBgAlpha(0.95f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
    // Notifications from an open dialog are shown in front of it, and clicks pass through them. Older ones
    // would cover its buttons. A file dialog's notification arrives just before the previous dialog reopens.
    const double left = note.since + seconds_over_dialog - ImGui::GetTime();
    const bool over_dialog = ImGui::GetTopMostPopupModal() != nullptr && left > 0 &&
                             note.frame + frames_to_come_back > GImGui->OpenPopupStack.front().OpenFrameCount;
    if (over_dialog) redraw_within(left);
    ImGui::Begin("##note0", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav | (over_dialog ? ImGuiWindowFlags_NoInputs : 0));
    if (over_dialog)
        ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    else if (ImGuiWindow* dialog = ImGui::GetTopMostPopupModal())
        ImGui::BringWindowToDisplayBehind(ImGui::GetCurrentWindow(), dialog);
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, low + size);  // the window's own clip rectangle excludes its padding
    list.AddRectFilled(low, {low.x + px(4), low.y + size.y}, to_u32(ink(note.tone)), px(6),
                       ImDrawFlags_RoundCornersLeft);
    list.PopClipRect();
    ImGui::PushTextWrapPos(width - px(34));
    ImGui::TextUnformatted(note.text.c_str());
    ImGui::PopTextWrapPos();
    if (!note.button.empty()) {
        pressed = ImGui::Button(note.button.c_str());
        list_control(note.button.c_str(), "", last_item());
    }
    ImGui::SetCursorPos({width - px(30), px(6)});
    const bool closed = icon_button("##close", Icon::Close) || pressed;
    ImGui::End();
    ImGui::PopStyleVar();
    return closed;
}

}  // namespace

void Notifications::tell(const std::string& text, Tone tone) {
    ++told;
    add(tone, text);
    list.back().of_key = true;
}

void Notifications::add(Tone tone, const std::string& whole) {
    std::string text = without_middle(whole);
    const double now = ImGui::GetTime();
    const int frame = ImGui::GetFrameCount();
    const auto joins = [&](const Notification& first) {
        const bool is_unread = first.tone == Tone::Error && now - first.since < seconds_to_read;
        return first.frame == frame || is_unread;
    };
    if (!list.empty() && joins(list.back())) {
        const Notification& first = list.back();
        tone = std::max(tone, first.tone);
        text =
            first.text.find(text) == first.text.npos ? without_middle(first.text + "\n" + text) : first.text;
    }
    list = {{tone, text, now + seconds_shown(tone), false, now, frame}};
}

void Notifications::add(const Warnings& warnings) {
    for (const std::string& warning : warnings) add(Tone::Warning, warning);
}

void draw_notifications(UiState& state, ImVec2 low_right, float top, float max_width) {
    auto& list = state.notifications.list;
    const double now = ImGui::GetTime();
    list.erase(
        std::remove_if(list.begin(), list.end(), [now](const Notification& n) { return n.until <= now; }),
        list.end());
    if (list.empty()) return;
    redraw_within(list.back().until - now);
    bool pressed = false;
    if (!draw_one(list.back(), pressed, low_right, top, std::min(px(420), max_width))) return;
    const Notification note = std::exchange(list, {}).back();
    if (pressed) note.press(state);
}

}  // namespace glint
