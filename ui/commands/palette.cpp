#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "ui/commands/fuzzy.h"
#include "ui/commands/menus.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int rows_shown = 11;

/// Draws `name` with the letters that matched in the accent's colour.
void draw_matched(ImDrawList& list, ImVec2 at, const std::string& name, const std::string& text,
                  const ImVec4& ink) {
    const auto match = fuzzy_match(text, name);
    std::size_t from = 0;
    const auto piece = [&](std::size_t to, const ImVec4& colour) {
        if (to <= from) return;
        const char *first = name.data() + from, *last = name.data() + to;
        list.AddText(at, to_u32(colour), first, last);
        at.x += ImGui::CalcTextSize(first, last).x;
        from = to;
    };
    if (match)
        for (const int byte : match->bytes) {
            if (name[static_cast<std::size_t>(byte)] & 0x80) continue;  // half a letter
            piece(static_cast<std::size_t>(byte), ink);
            piece(static_cast<std::size_t>(byte) + 1, theme().accent);
        }
    piece(name.size(), ink);
}

/// True when it was clicked.
bool entry_row(const PaletteEntry& entry, const std::string& text, bool chosen, int index) {
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
    draw_matched(list, {low.x + px(8), y}, entry.name, text, possible ? theme().text : theme().disabled_text);
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

/// Keys of the list. True when Enter chose.
bool move_choice(PaletteState& state, const UiInput& input, int count) {
    bool decided = false;
    for (const KeyPress& press : input.presses) {
        if (press.key == Key::Up) --state.chosen;
        if (press.key == Key::Down) ++state.chosen;
        if (press.key == Key::Enter) decided = !state.appearing;
    }
    if (count > 0) state.chosen = (state.chosen % count + count) % count;
    return decided && count > 0;
}

/// The index of the entry that was decided upon, or -1.
int entry_list(PaletteState& state, const UiInput& input) {
    const std::vector<int> matches = palette_matches(state.entries, state.text);
    const int before = state.chosen;
    int decided = -1;
    if (move_choice(state, input, static_cast<int>(matches.size())))
        decided = matches[static_cast<std::size_t>(state.chosen)];
    const float line = ImGui::GetFrameHeight() + px(1);
    ImGui::BeginChild("##entries", {0, rows_shown * line});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, px(1)});
    for (std::size_t i = 0; i < matches.size(); ++i) {
        const bool chosen = static_cast<int>(i) == state.chosen;
        const PaletteEntry& entry = state.entries[static_cast<std::size_t>(matches[i])];
        if (entry_row(entry, state.text, chosen, static_cast<int>(i))) decided = matches[i];
        if (chosen && state.chosen != before) ImGui::SetScrollHereY(0.5f);
    }
    ImGui::PopStyleVar();
    if (matches.empty()) dim_text("No match");
    ImGui::EndChild();
    return decided;
}

void run_entry(UiState& state, int index) {
    const PaletteEntry entry = state.palette.entries[static_cast<std::size_t>(index)];
    if (!entry.refused.empty()) return state.notifications.add(Tone::Warning, entry.refused);
    state.palette.open = false;
    entry.run(state);
}

}  // namespace

std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries, const std::string& text) {
    std::vector<std::pair<int, int>> scored;  // score, index
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto in_name = fuzzy_match(text, entries[i].name);
        const auto match = in_name ? in_name : fuzzy_match(text, entries[i].name + " " + entries[i].group);
        if (match) scored.emplace_back(match->score, static_cast<int>(i));
    }
    std::stable_sort(scored.begin(), scored.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<int> indices;
    indices.reserve(scored.size());
    for (const auto& [score, index] : scored) indices.push_back(index);
    return indices;
}

void open_palette(UiState& state) {
    state.palette = {true, true, "", 0, palette_entries(state), item_counts(state.editor.scene())};
}

void palette(UiState& state, const UiInput& input) {
    PaletteState& palette = state.palette;
    if (!palette.open) return;
    if (const ItemCounts now = item_counts(state.editor.scene()); now != palette.made_for)
        palette.entries = palette_entries(state), palette.made_for = now;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(px(560), window.x - px(20));
    ImGui::SetNextWindowPos({(window.x - width) / 2, std::min(px(90), window.y / 8)});
    ImGui::SetNextWindowSize({width, 0});
    if (palette.appearing) ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin("##palette", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav);
    if (palette.appearing) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##text", "What would you like to do?", &palette.text)) palette.chosen = 0;
    const int decided = entry_list(palette, input);
    const bool left = !palette.appearing && !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    palette.appearing = false;
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (left) palette.open = false;
    if (decided >= 0) run_entry(state, decided);
}

}  // namespace glint
