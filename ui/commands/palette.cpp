#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include "models/problem.h"
#include "ui/commands/command.h"
#include "ui/commands/fuzzy.h"
#include "ui/commands/menus.h"
#include "ui/commands/palette_rows.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/text/text_field.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int rows_shown = 11;

/// How many letters both have, capitals or not, wherever they stand.
std::size_t shared_letters(const std::string& a, const std::string& b) {
    std::array<int, 256> left{};
    for (const unsigned char c : b) ++left[static_cast<unsigned char>(std::tolower(c))];
    return static_cast<std::size_t>(std::count_if(a.begin(), a.end(), [&](unsigned char c) {
        return left[static_cast<unsigned char>(std::tolower(c))]-- > 0;
    }));
}

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; }

std::vector<std::string_view> words_in(std::string_view text) {
    std::vector<std::string_view> words;
    while (true) {
        const auto first = std::find_if(text.begin(), text.end(), is_of_word);
        const auto end = std::find_if_not(first, text.end(), is_of_word);
        if (first == end) return words;
        words.emplace_back(&*first, static_cast<std::size_t>(end - first));
        text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    }
}

/// How many letters of a word of `text` are behind `start`, capitals or not; the fewest; nothing where no
/// word begins so.
std::optional<std::size_t> rest_of_word(std::string_view text, std::string_view start) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    const auto begins = [&](std::string_view word) {
        return word.size() >= start.size() && std::equal(start.begin(), start.end(), word.begin(), same);
    };
    std::optional<std::size_t> least;
    for (const std::string_view word : words_in(text))
        if (begins(word)) least = std::min(least.value_or(word.size()), word.size() - start.size());
    return least;
}

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

PaletteFound find(const std::vector<PaletteEntry>& entries, const std::string& text) {
    PaletteFound found{palette_matches(entries, text), text};
    if (!found.matches.empty()) return found;
    found.marked = nearest_word(entries, text);
    if (!found.marked.empty()) found.matches = palette_matches(entries, found.marked);
    return found;
}

void nothing_found(const std::string& text, const std::string& nearest) {
    const std::string nothing = fmt::format("Nothing is called “{}”", text);
    wrapped_dim(nearest.empty() ? nothing + ": commands, fields and scenes are found here"
                                : fmt::format("{}. Nearest is “{}”:", nothing, nearest));
}

/// Draws the rows in sight, and the chosen one where it shall be brought there. Returns the index of the one
/// that was clicked, or -1.
int entry_rows(const PaletteState& state, const PaletteFound& found, bool shows_chosen) {
    int clicked = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, px(1)});
    ImGuiListClipper rows;
    rows.Begin(static_cast<int>(found.matches.size()), ImGui::GetFrameHeight() + px(1));
    if (shows_chosen) rows.ForceDisplayRangeByIndices(state.chosen, state.chosen + 1);
    while (rows.Step())
        for (int i = rows.DisplayStart; i < rows.DisplayEnd; ++i) {
            const int index = found.matches[static_cast<std::size_t>(i)];
            const PaletteEntry& entry = state.entries[static_cast<std::size_t>(index)];
            if (entry_row(entry, found.marked, i == state.chosen, i)) clicked = index;
            if (shows_chosen && i == state.chosen) ImGui::SetScrollHereY(0.5f);
        }
    ImGui::PopStyleVar();
    return clicked;
}

/// The index of the entry that was decided upon, or -1.
int entry_list(PaletteState& state, const UiInput& input) {
    const PaletteFound& found = state.found.of(state.text, [&] { return find(state.entries, state.text); });
    if (found.marked != state.text) nothing_found(state.text, found.marked);
    const int before = state.chosen;
    const int count = static_cast<int>(found.matches.size());
    const bool entered = choose_by_keys(state.chosen, count, 1, input) && !state.takes_keyboard;
    ImGui::BeginChild("##entries", {0, rows_shown * (ImGui::GetFrameHeight() + px(1))});
    const int clicked = entry_rows(state, found, state.chosen >= 0 && state.chosen != before);
    ImGui::EndChild();
    if (clicked >= 0 || !entered) return clicked;
    return found.matches[static_cast<std::size_t>(state.chosen)];
}

void run_entry(UiState& state, int index) {
    const PaletteEntry entry = state.palette.entries[static_cast<std::size_t>(index)];
    if (!entry.refused.empty()) return state.notifications.add(Tone::Warning, entry.refused);
    state.palette.open = false;
    entry.run(state);
}

/// Letters strewn over a long name fit by chance: a match is meant if it begins words, or holds together.
bool is_meant(const FuzzyMatch& match, std::string_view text, int least_in_twelfths = 8) {
    int best = 0;  // what the same letters score side by side from the beginning of a word
    for (const std::string_view word : words_in(text)) best += fuzzy_match(word, word)->score;
    return 12 * match.score >= least_in_twelfths * best;
}

/// How well an entry fits what was typed; nothing where it does not. By its name, else with its group, else
/// by a word about it.
std::optional<int> fit(const PaletteEntry& entry, const std::string& text) {
    const auto rest = rest_of_word(entry.words, text);
    // A whole word about it is meant more than letters that are strewn over another's name.
    const int about = rest == 0U ? fuzzy_match(text, text)->score * 9 / 10 : 0;
    if (const auto by_name = fuzzy_match(text, entry.name); by_name && is_meant(*by_name, text)) {
        const int all_as_long = entry.keeps_order ? off_for_length(entry.name) - most_for_length : 0;
        return std::max(by_name->score + all_as_long, about);
    }
    const auto with_group = fuzzy_match(text, entry.name + " " + entry.group);
    if (with_group && is_meant(*with_group, text, 10)) return std::max(with_group->score / 2, about);
    return rest ? std::optional(about) : std::nullopt;
}

}  // namespace

std::string with_spaces(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '-' || c == '_'; }, ' ');
    return name;
}

std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries, const std::string& text) {
    std::vector<std::pair<int, int>> scored;  // score, index
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (const auto score = fit(entries[i], text)) scored.emplace_back(*score, static_cast<int>(i));
    std::stable_sort(scored.begin(), scored.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<int> indices;
    indices.reserve(scored.size());
    for (const auto& [score, index] : scored) indices.push_back(index);
    if (!indices.empty()) return indices;
    const std::string words = with_spaces(text);
    return words == text ? indices : palette_matches(entries, words);
}

std::string nearest_word(const std::vector<PaletteEntry>& entries, const std::string& text) {
    std::vector<std::string> words;
    for (const PaletteEntry& entry : entries)
        for (const std::string& said : {entry.name, entry.words})
            for (const std::string_view word : words_in(said))
                if (word.size() > 2) words.emplace_back(word);
    const std::string best = nearest(text, words);
    return shared_letters(text, best) >= (text.size() + 1) / 2 ? best : std::string();
}

namespace {

/// ImGui gives a field the keyboard two frames after the request, and drops what is typed until then. So
/// letters are kept, and typed when the field has the keyboard. If other keys came before the one that opens
/// the list, nobody knows which letters are meant for the list: none are kept.
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

void open_palette(UiState& state) {
    state.palette = {};
    state.palette.open = state.palette.takes_keyboard = true;
    if (state.lessons.own.empty()) list_own_lessons(state);
    state.palette.entries = palette_entries(state);
    state.palette.made_for = item_counts(state.editor.scene());
}

void palette(UiState& state, const UiInput& input) {
    PaletteState& palette = state.palette;
    if (!palette.open) return;
    if (const ItemCounts now = item_counts(state.editor.scene()); now != palette.made_for)
        palette.entries = palette_entries(state), palette.made_for = now, palette.found.forget();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(px(560), window.x - px(20));
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
    if (text_field("##text", "What would you like to do?", palette.text, 0, longest_search))
        palette.chosen = palette.text.empty() ? -1 : 0;
    palette.has_keyboard = ImGui::IsItemActive();
    const int decided = entry_list(palette, input);
    const bool left = !palette.takes_keyboard && !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    const bool entered = std::any_of(input.presses.begin(), input.presses.end(),
                                     [](const KeyPress& press) { return press.key == Key::Enter; });
    palette.takes_keyboard = entered && decided < 0;  // Enter took the keyboard from the text
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (left) palette.open = false;
    if (decided >= 0) run_entry(state, decided);
}

}  // namespace glint
