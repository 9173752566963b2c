#include "ui/features/inspector/mistake_row.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>

#include "ui/commands/match.h"
#include "ui/features/inspector/mistake_pictures.h"
#include "ui/widgets/area.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The lower lines of its tooltip: similar mistakes, and who reported it.
std::string notes_on(const MistakeName& mistake) {
    std::string notes;
    if (!mistake.look_alikes.empty()) {
        std::string names(mistake.look_alikes);
        std::replace(names.begin(), names.end(), ' ', '\n');
        notes += fmt::format("Looks like:\n{}\n", with_spaces(names));
    }
    if (!mistake.sources.empty()) notes += fmt::format("Asked in: {}\n", mistake.sources);
    return notes + "off by default";
}

/// One line in the current font, cut off with dots.
void cut_line(ImDrawList& list, const Rect& line, const ImVec4& colour, std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    cut_text(list, line.low, line.high.x, text);
    ImGui::PopStyleColor();
}

/// Draws text in the current font, wrapped to as many lines as fit into `area`, the last one cut off with
/// dots. Returns the lower end of the text.
float broken_lines(ImDrawList& list, const Rect& area, const ImVec4& colour, std::string_view words) {
    const float height = ImGui::GetTextLineHeight();
    const char *at = words.data(), *const end = at + words.size();
    float y = area.low.y;
    while (at < end && y + height <= area.high.y) {
        const bool is_last = y + 2 * height > area.high.y;
        const char* const next =
            is_last ? end
                    : ImGui::GetFont()->CalcWordWrapPositionA(
                          ImGui::GetFontSize() / ImGui::GetFont()->FontSize, at, end, area.size().x);
        cut_line(list, {{area.low.x, y}, {area.high.x, y + height}}, colour, {at, next});
        at = next;
        while (at < end && *at == ' ') ++at;
        y += height;
    }
    return y;
}

/// The switch's box, `edge` wide.
void box(ImVec2 low, float edge, bool on) {
    const ImVec2 high = low + ImVec2(edge, edge);
    ImGui::RenderFrame(low, high, to_u32(theme().field), true, px(3));
    const float inset = std::max(1.0f, std::floor(edge / 6));
    if (on)
        ImGui::RenderCheckMark(ImGui::GetWindowDrawList(), low + ImVec2(inset, inset), to_u32(theme().accent),
                               edge - 2 * inset);
}

/// Draws, next to the picture: the switch and the name, how to recognise the mistake, and who reported it.
void words_of(const MistakeName& mistake, bool on, bool dim, const Rect& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    box({area.low.x, area.low.y + px(1)}, line - px(2), on);
    const std::string title = title_of(mistake);
    Rect first{area.low + ImVec2(line + px(4), 0), {area.high.x, area.low.y + line}};
    const ImVec4& ink = dim ? theme().dim_text : theme().text;
    const bool fits = ImGui::CalcTextSize(title.c_str()).x <= first.size().x;
    if (fits) cut_line(list, first, ink, title);
    ImGui::PushFont(fonts().small);
    const float small_line = ImGui::GetTextLineHeight(), last = mistake.sources.empty() ? 0 : small_line;
    if (!fits)
        first.high.y =
            broken_lines(list, {first.low, {first.high.x, first.low.y + 2 * small_line}}, ink, title);
    const float y = broken_lines(list, {{area.low.x, first.high.y + px(2)}, area.high - ImVec2(0, last)},
                                 theme().dim_text, mistake.looks);
    // One line, because a tracker's name and number cannot be wrapped. The tooltip lists all of them.
    cut_line(list, {{area.low.x, y}, {area.high.x, y + last}}, theme().disabled_text, mistake.sources);
    ImGui::PopFont();
}

}  // namespace

std::string title_of(const MistakeName& mistake) {
    std::string title = with_spaces(mistake.name);
    if (title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

std::string SmallLook::words(int index) const {
    const auto place = static_cast<std::size_t>(index);
    return place < pictures.words.size() ? pictures.words[place] : std::string();
}

float small_inset() { return px(4); }

void draw_small(const SmallLook& look, int index, ImVec2 low) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high = low + look.extent();
    const SmallPictures& pictures = look.pictures;
    const std::string words = look.words(index);
    const float strength = index < pictures.taken ? 1 : 0.4f;
    list.AddRectFilled(low, high, to_u32(theme().field), px(3));
    ImGui::PushFont(fonts().small);
    if (words == no_difference) {
        const float wrap = look.extent().x - px(8);
        const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, wrap);
        list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), (low + high - size) / 2,
                     to_u32(theme().dim_text, strength), words.c_str(), nullptr, wrap);
    } else if (pictures.sheet.serial > 0) {
        pictures.sheet.draw(list, index, low, high, strength);
        const float line = ImGui::GetTextLineHeight();
        if (!words.empty())
            rimmed_text(list, {(low.x + high.x) / 2, high.y - line / 2 - px(2)}, {1, 1, 1, strength}, words);
    }
    ImGui::PopFont();
}

bool mistake_row(const MistakeName& mistake, bool& on, const SmallLook& look, int index) {
    const float inset = small_inset(), wide = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(index);
    if (hit_area("##mistake", {wide, look.extent().y + 2 * inset})) on = !on;
    ImGui::PopID();
    if (!ImGui::IsItemVisible()) return false;  // most rows are scrolled away: skips their texts
    const bool pointed = is_pointed_at();
    tooltip(title_of(mistake).c_str(), fmt::format("{} {}", mistake.what, mistake.looks).c_str(),
            notes_on(mistake), fmt::format("/shading/mistakes/{}", mistake.name));
    const auto [low, high] = last_item();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (pointed) list.AddRectFilled(low, high, to_u32(theme().field_hovered), px(4));
    const ImVec2 corner = low + ImVec2(inset, inset);
    draw_small(look, index, corner);
    if (on) list.AddRect(corner, corner + look.extent(), to_u32(theme().accent), px(3), 0, px(2));
    words_of(mistake, on, look.words(index) == no_difference,
             {corner + ImVec2(look.extent().x + px(8), 0), high - ImVec2(inset, inset)});
    return pointed;
}

}  // namespace glint
