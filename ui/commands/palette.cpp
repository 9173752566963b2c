#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "models/problem.h"
#include "ui/commands/command.h"
#include "ui/commands/match.h"
#include "ui/commands/menus.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/text/text_field.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int rows_shown = 11;

/// The rank of an entry; lower is better. Matches its name, the beginning of a search term, or its name
/// together with its group.
std::optional<int> rank_of(const PaletteEntry& entry, const std::string& text) {
    const std::optional<int> by_name = match_rank(text, entry.name);
    if (by_name && *by_name <= 2) return by_name;
    if (match_rank(text, entry.words).value_or(3) <= 2) return 3;
    if (by_name) return *by_name + 1;
    if (match_rank(text, entry.name + " " + entry.group).value_or(4) <= 3) return 6;
    return {};
}

/// True when clicked.
bool entry_row(const PaletteEntry& entry, bool chosen, int index) {
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushID(index);
    const bool clicked = hit_area("##entry", {width, height});
    if (ImGui::IsItemHovered() && !entry.refused.empty()) tooltip(entry.name.c_str(), entry.refused.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen || ImGui::IsItemHovered())
        list.AddRectFilled(low, {low.x + width, low.y + height},
                           to_u32(chosen ? theme().field_active : theme().field), px(4));
    const float y = low.y + (height - ImGui::GetTextLineHeight()) / 2;
    const bool possible = entry.refused.empty();
    list.AddText({low.x + px(8), y}, to_u32(possible ? theme().text : theme().disabled_text),
                 entry.name.c_str());
    const std::string note = possible ? entry.group : entry.refused;
    const float keys_width = entry.keys.empty() ? 0 : ImGui::CalcTextSize(entry.keys.c_str()).x + px(14);
    const float note_width = ImGui::CalcTextSize(note.c_str()).x;
    const float right = low.x + width - px(8);
    const float name_end = low.x + px(20) + ImGui::CalcTextSize(entry.name.c_str()).x;
    if (right - keys_width - note_width > name_end)
        list.AddText({right - keys_width - note_width, y}, to_u32(theme().dim_text), note.c_str());
    if (!entry.keys.empty())
        list.AddText({right - keys_width + px(14), y}, to_u32(theme().accent), entry.keys.c_str());
    ImGui::PopID();
    return clicked;
}

/// Draws the visible rows, and the chosen one if it must be scrolled to. Returns the index of the clicked
/// entry, or -1.
int entry_rows(const PaletteState& state, bool shows_chosen) {
    int clicked = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, px(1)});
    ImGuiListClipper rows;
    rows.Begin(static_cast<int>(state.matches.size()), ImGui::GetFrameHeight() + px(1));
    if (shows_chosen) rows.ForceDisplayRangeByIndices(state.chosen, state.chosen + 1);
    while (rows.Step())
        for (int i = rows.DisplayStart; i < rows.DisplayEnd; ++i) {
            const int index = state.matches[static_cast<std::size_t>(i)];
            if (entry_row(state.entries[static_cast<std::size_t>(index)], i == state.chosen, i))
                clicked = index;
            if (shows_chosen && i == state.chosen) ImGui::SetScrollHereY(0.5f);
        }
    ImGui::PopStyleVar();
    return clicked;
}

/// The index of the confirmed entry, or -1.
int entry_list(PaletteState& state, const UiInput& input) {
    if (state.matches.empty())
        wrapped_dim(fmt::format("Nothing is called “{}”: this finds commands, fields, scenes and lessons",
                                shortened(state.text)));
    const int before = state.chosen, count = static_cast<int>(state.matches.size());
    const int shown = std::clamp(count, 1, rows_shown);
    const bool entered = choose_by_keys(state.chosen, count, 1, input) && !state.takes_keyboard;
    ImGui::BeginChild("##entries", {0, static_cast<float>(shown) * (ImGui::GetFrameHeight() + px(1))});
    const int clicked = entry_rows(state, state.chosen >= 0 && state.chosen != before);
    ImGui::EndChild();
    if (clicked >= 0 || !entered) return clicked;
    return state.matches[static_cast<std::size_t>(state.chosen)];
}

void run_entry(UiState& state, int index) {
    const PaletteEntry entry = state.palette.entries[static_cast<std::size_t>(index)];
    if (!entry.refused.empty()) return state.notifications.add(Tone::Warning, entry.refused);
    state.palette.open = false;
    entry.run(state);
}

/// ImGui focuses a field two frames after the request, and drops letters typed until then. So letters are
/// kept, and typed once the field has focus. If other keys came before the key that opens the list, it is
/// unknown which letters are meant for the list, and none are kept.
void type_ahead(PaletteState& state, const UiInput& input) {
    ImVector<ImWchar>& queue = ImGui::GetIO().InputQueueCharacters;
    std::vector<ImWchar>& ahead = state.typed_ahead;
    if (state.has_keyboard) {
        for (std::size_t i = 0; i < ahead.size(); ++i) queue.insert(queue.begin() + i, ahead[i]);
        return ahead.clear();
    }
    const auto opens = std::find_if(input.presses.begin(), input.presses.end(), [](KeyPress press) {
        return text_of(press) == keys_of(CommandId::Palette);
    });
    if (opens == input.presses.begin() || opens == input.presses.end())
        ahead.insert(ahead.end(), queue.begin(), queue.end());
}

}  // namespace

std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries, const std::string& text) {
    std::vector<std::tuple<int, bool, int>> ranked;  // rank, whether it cannot run, index
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (const auto rank = rank_of(entries[i], text))
            ranked.emplace_back(*rank, !text.empty() && !entries[i].refused.empty(), static_cast<int>(i));
    std::sort(ranked.begin(), ranked.end());
    std::vector<int> indices;
    indices.reserve(ranked.size());
    for (const auto& [rank, refused, index] : ranked) indices.push_back(index);
    return indices;
}

void open_palette(UiState& state) {
    PaletteState& palette = state.palette;
    palette = {};
    palette.open = palette.takes_keyboard = true;
    palette.entries = palette_entries(state);
    palette.matches = palette_matches(palette.entries, "");
    palette.made_for = item_counts(state.editor.scene());
    const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
    for (const PaletteEntry& entry : palette.entries)
        palette.width = std::max(palette.width, width(entry.name) + width(entry.keys) + px(60));
}

void palette(UiState& state, const UiInput& input) {
    PaletteState& palette = state.palette;
    // Entries refer to lights and objects by index.
    if (item_counts(state.editor.scene()) != palette.made_for) palette.open = false;
    if (!palette.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(std::clamp(palette.width, px(380), px(560)), window.x - px(20));
    ImGui::SetNextWindowPos({(window.x - width) / 2, std::min(px(90), window.y / 8)});
    ImGui::SetNextWindowSize({width, 0});
    if (palette.takes_keyboard) ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin("##palette", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav);
    if (palette.takes_keyboard) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    type_ahead(palette, input);
    if (text_field("##text", "What would you like to do?", palette.text)) {
        palette.matches = palette_matches(palette.entries, palette.text);
        palette.chosen = palette.text.empty() ? -1 : 0;
    }
    palette.has_keyboard = ImGui::IsItemActive();
    const int decided = entry_list(palette, input);
    const bool left = !palette.takes_keyboard && !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    const bool entered = std::any_of(input.presses.begin(), input.presses.end(),
                                     [](const KeyPress& press) { return press.key == Key::Enter; });
    palette.takes_keyboard = entered && decided < 0;  // Enter removed the focus from the text
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (left) palette.open = false;
    if (decided >= 0) run_entry(state, decided);
}

}  // namespace glint
