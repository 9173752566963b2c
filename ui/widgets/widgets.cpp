#include "ui/widgets/widgets.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "models/utf8.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

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
    if (std::isnan(initial)) return text;  // the number has no default
    return fmt::format("{}{}default {}", text, text.empty() ? "" : ", ", shown(initial));
}

void number_tooltip(const char* label, const Real& kind, float initial, const Help& help) {
    const char* const hand =
        is_read_only()
            ? ""
            : "\nDrag (Shift: fine, Ctrl: steps) · Click: type, even 2*pi or +0.1 · Right click: menu";
    tooltip(label, help.what, range_text(kind, initial) + hand, help.pointer);
}

}  // namespace

bool is_read_only() { return (GImGui->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0; }

bool hit_area(const char* id, ImVec2 size, ImGuiButtonFlags flags) {
    return ImGui::InvisibleButton(id, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)}, flags);
}

float label_cell(const char* label) {
    const float label_width = px(88);
    const float left = ImGui::GetCursorPosX();
    const char* const end = ImGui::FindRenderedTextEnd(label);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, theme().dim_text);
    ImGui::TextUnformatted(label, end);
    ImGui::PopStyleColor();
    ImGui::SameLine(left + std::max(label_width, ImGui::CalcTextSize(label, end).x + px(6)), 0);
    return ImGui::GetContentRegionAvail().x;
}

bool number_field(const char* label, float& value, const Real& kind, float initial, const Help& help) {
    ImGui::PushID(label);
    const float width = label_cell(label);
    const bool changed =
        number_input("##number", value, {kind, initial, help.pointer, width, has_slider(kind)});
    number_tooltip(label, kind, initial, help);
    ImGui::PopID();
    return changed;
}

bool bare_number(const char* label, float& value, const Real& kind, float initial, const Help& help,
                 float width) {
    ImGui::PushID(label);
    const bool changed = number_input("##number", value, {kind, initial, help.pointer, width});
    number_tooltip(label, kind, initial, help);
    ImGui::PopID();
    return changed;
}

bool integer_field(const char* label, int& value, const Count& count, int initial, const Help& help) {
    const int low = count.low, high = count.high;
    const std::string words = fmt::format("{} to {}", low, high);
    // A drag of 300 pixels goes from the default to four times the default, regardless of the limit.
    const Real kind{.range = {double(low), double(high), words},
                    .step = std::max(0.03f, float(initial) / 100),
                    .format = "%.0f",
                    .usual_max = high <= 64 ? float(high) : 0,
                    .zero = count.zero};
    float real = float(value);
    if (!number_field(label, real, kind, float(initial), help)) return false;
    if (real != std::round(real)) {  // the number was typed or pasted, because a drag gives integers
        refuse_edit("the field accepts only whole numbers");
        return false;
    }
    const int whole = static_cast<int>(std::clamp(double(real), double(low), double(high)));
    const bool changed = whole != value;
    value = whole;
    return changed;
}

void vector_field(const char* label, glm::vec3& value, const Real& kind, glm::vec3 initial,
                  const Help& help) {
    ImGui::PushID(label);
    const float gap = px(3), width = (label_cell(label) - 2 * gap) / 3;
    for (int i = 0; i < 3; ++i) {
        ImGui::PushID(i);
        if (i > 0) ImGui::SameLine(0, gap);
        const std::string pointer =
            help.pointer.empty() ? std::string() : help.pointer + "/" + std::to_string(i);
        number_input("##part", value[i], {kind, initial[i], pointer, width});
        const char* const names[] = {"x", "y", "z"};
        number_tooltip(fmt::format("{} {}", label, names[i]).c_str(), kind, initial[i], {help.what, pointer});
        ImGui::PopID();
    }
    ImGui::PopID();
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

void bare_name(const char* id, std::string& name, std::size_t max_characters, int flags) {
    if (!text_field(id, "", name, flags)) return;
    name = with_invalid_replaced(name);  // scene files are UTF-8, but pasted text may not be
    if (max_characters > 0) name = first_characters(name, max_characters);
}

void name_field(const char* label, std::string& name, std::size_t max_characters, const Help& help) {
    ImGui::PushID(label);
    ImGui::SetNextItemWidth(label_cell(label));
    bare_name("##name", name, max_characters);
    const bool is_cut = ImGui::CalcTextSize(name.c_str()).x > ImGui::GetItemRectSize().x - px(12);
    tooltip(label, help.what, is_cut ? name : "", help.pointer);
    ImGui::PopID();
}

void section_heading(const char* title) {
    ImGui::Dummy({0, px(3)});
    ImGui::PushFont(fonts().small);
    ImGui::PushTextWrapPos(0);
    dim_text(title);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float y = (low.y + high.y) / 2, right = low.x + ImGui::GetContentRegionAvail().x;
    if (high.x + px(6) < right)
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

const States& widget_states() {
    void*& states = ImGui::GetIO().UserData;
    if (states != nullptr) return *static_cast<States*>(states);
    ImGuiContextHook hook;
    hook.Type = ImGuiContextHookType_Shutdown;
    hook.Callback = [](ImGuiContext* context, ImGuiContextHook*) {
        delete static_cast<States*>(context->IO.UserData);
    };
    ImGui::AddContextHook(GImGui, &hook);
    states = new States;
    return *static_cast<States*>(states);
}

namespace {

struct Clipboard {
    const char* (*get)(void*) = nullptr;
    std::string line;
};

const char* text_in_one_line(void* data) {
    auto& [get, line] = widget_state<Clipboard>();
    const char* const text = get != nullptr ? get(data) : nullptr;
    if (text == nullptr) return nullptr;
    line = text;
    line.resize(line.find_last_not_of(" \t\r\n") + 1);  // a copied line ends with a line break
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return line.c_str();
}

/// Returns the text that Dear ImGui produces when a field had focus but was not edited: it replaces
/// characters with others of a different length, but cuts the result at the original length.
std::string as_visited(const std::string& text) {
    std::vector<ImWchar> wide(text.size() + 1);
    ImTextStrFromUtf8(wide.data(), static_cast<int>(wide.size()), text.c_str(), nullptr);
    std::string narrow(4 * wide.size(), '\0');
    const int length = ImTextStrToUtf8(narrow.data(), static_cast<int>(narrow.size()), wide.data(), nullptr);
    narrow.resize(std::min(static_cast<std::size_t>(length), text.size()));
    return narrow;
}

}  // namespace

PasteInOneLine::PasteInOneLine() {
    widget_state<Clipboard>().get = ImGui::GetIO().GetClipboardTextFn;
    ImGui::GetIO().GetClipboardTextFn = text_in_one_line;
}

PasteInOneLine::~PasteInOneLine() { ImGui::GetIO().GetClipboardTextFn = widget_state<Clipboard>().get; }

bool text_field(const char* label, const char* hint, std::string& text, int flags) {
    const PasteInOneLine pasted;
    std::string edited = text;
    const bool returned = ImGui::InputTextWithHint(label, hint, &edited, flags);
    edited.resize(std::strlen(edited.c_str()));
    const bool changed = edited != text && edited != as_visited(text);
    if (changed) text = edited;
    return (flags & ImGuiInputTextFlags_EnterReturnsTrue) != 0 ? returned : changed;
}

// Describes a control, to the user in a tooltip and to tests by name.

namespace {

constexpr double rest_before_tooltip = 0.45;  // seconds

/// The item under the pointer.
struct Resting {
    ImGuiID item = 0;  // 0: `at` identifies the item
    ImVec2 at;
    double since = 0;
    int frame = -1;        // the last frame in which the pointer was on it
    bool clicked = false;  // the user knows the item, so no tooltip appears until the pointer has left it
};
struct ControlsState {
    double earliest_redraw = std::numeric_limits<double>::infinity();
    Resting resting;
    /// The position of a click that silenced tooltips. They stay hidden until the pointer moves, so that they
    /// do not cover what the click opened.
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
