#include "ui/shell/notifications.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "models/utf8.h"
#include "ui/feature.h"
#include "ui/picture/tool.h"
#include "ui/shell/columns.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double seconds_over_dialog = 10;
constexpr double seconds_to_read = 2;      // minimum time before another message may replace an error
constexpr int frames_to_come_back = 3;     // ImGui frames until a dialog reopens after a file dialog
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

/// Cuts the middle out of a long text, because its beginning says where the problem is, and its end says what
/// was expected.
std::string without_middle(const std::string& text) {
    if (text.size() <= longest_text) return text;
    std::size_t head = longest_text * 2 / 3, tail = text.size() - longest_text / 3;
    while (continues_character(text[head])) --head;
    while (tail < text.size() && continues_character(text[tail])) ++tail;
    return text.substr(0, head) + " … " + text.substr(tail);
}

/// Draws the notification upwards from `low_right` to at most `top`. If the text is taller, it scrolls with
/// the wheel and the close button stays visible. True when it is closed; `pressed` is set if its own button
/// closed it.
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

// The status line at the bottom.

namespace {

constexpr std::array<const char*, stage_count> stage_names{"geometry", "visibility", "surface", "transport",
                                                           "lighting"};

std::string stats_text(const UiState& state) {
    const std::size_t triangles = state.renderer->stats().triangles,
                      lights = state.rendered_scene.lights.size();
    return fmt::format("{} {}  ·  {} {}", with_thousands(triangles),
                       triangles == 1 ? "triangle" : "triangles", lights, lights == 1 ? "light" : "lights");
}

void stats_tooltip(const FrameStats& stats, double parts_ms) {
    std::string lines = fmt::format("{:.1f} ms\n", stats.total_ms + parts_ms);
    for (std::size_t i = 0; i < stage_count; ++i)
        lines += stats.redone[i] ? fmt::format("{}: {:.2f} ms\n", stage_names[i], stats.ms[i])
                                 : fmt::format("{}: kept\n", stage_names[i]);
    if (stats.strokes_redone) lines += fmt::format("strokes: {:.2f} ms\n", stats.strokes_ms);
    lines += fmt::format("{} pixels show a surface\n{} evaluations of the equation\n{} × {} threads",
                         with_thousands(stats.shaded_pixels), with_thousands(stats.evaluations),
                         stats.instruction_set, stats.threads);
    tooltip("Last picture", "What was recomputed, and how long it took", lines);
}

}  // namespace

void status_line(UiState& state, const Rect& area) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    ImGui::PushFont(fonts().small);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {px(10), (area.size().y - ImGui::GetTextLineHeight()) / 2});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme().window);
    ImGui::Begin("##status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    if (state.rendered != nullptr) {
        const std::string stats = stats_text(state);
        const float width = ImGui::CalcTextSize(stats.c_str()).x;
        const ImVec2 left = ImGui::GetCursorScreenPos();
        const float right = area.high.x - width - px(10);
        float mark = 0;
        for (const Feature* feature : features())
            if (feature->status != nullptr) mark += feature->status(state, {right - mark, left.y});
        const std::string hint = tools_hint(state);
        const float end = std::max(right - mark - px(16), left.x);
        cut_text(*ImGui::GetWindowDrawList(), left, end, hint);
        ImGui::SetCursorScreenPos({right, left.y});
        dim_text(stats.c_str());
        ImGui::PopFont();
        stats_tooltip(state.renderer->stats(), state.parts_ms);
        ImGui::PushFont(fonts().small);
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace glint
