#include "ui/commands/command.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "ui/document/scene_edit.h"
#include "ui/feature.h"
#include "ui/picture/tool.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"

namespace glint {
namespace {

/// Whether the key is a letter or a digit without Ctrl, which is easily pressed by mistake.
bool is_letter(KeyPress press) { return !press.ctrl && press.key <= Key::Digit4; }

/// Reports what a key did, or why it did nothing: "Specular: off (S)".
void tell(UiState& state, const WindowCommand& command, KeyPress press) {
    const std::string refused = why_disabled(state, command), key = " (" + text_of(press) + ")";
    const std::string_view sets = command.sets;
    std::string what = *command.noun != 0 ? command.noun : command.name;
    // A command that sets one of several values has no on or off state.
    if (const auto on = is_on(state, command); on && sets.find('=') == std::string_view::npos)
        what += *on ? ": on" : ": off";
    if (refused.empty())
        state.notifications.tell(what + key);
    else
        state.notifications.tell(refused + key, Tone::Warning);
}

std::vector<WindowCommand> all_commands() {
    std::vector<WindowCommand> all;
    const auto add = [&all](std::vector<WindowCommand> rows) {
        for (WindowCommand& row : rows) {
            const Menu menu = menu_of(row.section);
            row.quiet |= menu == Menu::File || menu == Menu::Help;
            all.push_back(std::move(row));
        }
    };
    for (const auto rows : {file_commands, edit_commands, light_commands, hand_commands, camera_commands,
                            view_commands, shading_commands})
        add(rows());
    for (const Feature* feature : features())
        if (feature->commands != nullptr) add(feature->commands());
    std::stable_sort(all.begin(), all.end(),
                     [](const WindowCommand& a, const WindowCommand& b) { return a.section < b.section; });
    return all;
}

}  // namespace

Menu menu_of(Section section) {
    if (section <= Section::FileQuit) return Menu::File;
    if (section == Section::Edit) return Menu::Edit;
    if (section <= Section::ViewWindow) return Menu::View;
    if (section <= Section::InspectFind) return Menu::Inspect;
    if (section <= Section::ComparePicture) return Menu::Compare;
    if (section <= Section::LectureWedge) return Menu::Lecture;
    return section == Section::Help ? Menu::Help : Menu::None;
}

std::span<const WindowCommand> commands() {
    static const std::vector<WindowCommand> all = all_commands();
    return all;
}

const WindowCommand& command(CommandId id) {
    for (const WindowCommand& row : commands())
        if (row.id == id) return row;
    throw std::logic_error("a command without a row in the table");  // a test looks up every command
}

std::string keys_of(const WindowCommand& command) {
    std::string keys;
    for (const KeyPress& press : command.keys) keys.append(keys.empty() ? "" : " or ").append(text_of(press));
    return keys;
}

std::string keys_of(CommandId id) { return keys_of(command(id)); }

std::string keys_of_value(std::string_view value) {
    if (value.empty()) return {};
    for (const WindowCommand& row : commands())
        if (row.sets == value) return keys_of(row);
    return {};
}

std::string why_disabled(const UiState& state, const WindowCommand& command) {
    if (std::string held = why_held(state); !held.empty() && !command.quiet) return held;
    return command.why_disabled == nullptr ? std::string() : command.why_disabled(state);
}

std::optional<bool> is_on(const UiState& state, const WindowCommand& command) {
    if (command.is_on == nullptr) return {};
    return command.is_on(state);
}

void run_command(UiState& state, const WindowCommand& command) {
    // The end of a drag or a load may have deleted the item since the last check.
    state.editor.selection = valid_selection(state.editor.selection, state.editor.scene());
    if (!can_run(state, command)) return;
    state.viewport.touched |= command.changes_picture;
    command.run(state);
}

namespace {

/// Whether a key belongs to the text being typed. The keys for saving, opening, quitting and the palette
/// still work, and so do the Page and F keys.
bool is_for_text(KeyPress press) {
    constexpr std::array of_window{Key::K, Key::N, Key::O, Key::Q, Key::S};
    if (press.key >= Key::PageUp && press.key <= Key::F12) return false;
    return !press.ctrl || std::find(of_window.begin(), of_window.end(), press.key) == of_window.end();
}

}  // namespace

void run_keys(UiState& state, const UiInput& input) {
    const bool busy =
        state.viewport.gesture != Gesture::None || (ImGui::IsAnyMouseDown() && ImGui::IsAnyItemActive());
    for (const KeyPress& press : input.presses) {
        if (press.key == Key::Escape && !number_in_hand()) escape(state);
        if (busy || state.palette.open || open_dialog(state) != nullptr) continue;
        if (ImGui::GetIO().WantTextInput && is_for_text(press)) continue;
        if (is_letter(press) && ImGui::GetTime() < state.letters_from) continue;
        const auto takes_key = [&](const Feature* feature) {
            return feature->key != nullptr && feature->key(state, press);
        };
        if (std::any_of(features().begin(), features().end(), takes_key)) continue;
        const auto has_key = [&press](const WindowCommand& command) {
            return std::find(command.keys.begin(), command.keys.end(), press) != command.keys.end();
        };
        const auto found = std::find_if(commands().begin(), commands().end(), has_key);
        if (found == commands().end()) continue;
        // Keys that are easily pressed by mistake report what they did; keys without effect report the
        // reason.
        const bool tells = is_letter(press) || !why_disabled(state, *found).empty();
        const int told_before = state.notifications.told;
        const ItemCounts before = item_counts(state.editor.scene());
        run_command(state, *found);
        // An open field or colour picker refers to its item by index, which would now belong to a different
        // item.
        if (item_counts(state.editor.scene()) != before) let_go_of_fields();
        if (tells && state.notifications.told == told_before)
            tell(state, *found, press);  // some commands report a better message
    }
}

namespace {

std::string name_of(Key key) {
    static constexpr const char* after_z[] = {"1",     "2",     "3",     "4",     "pad 0", "pad 1", "pad 3",
                                              "pad 5", "pad 7", "pad .", "Del",   "Esc",   "Enter", "Tab",
                                              "Up",    "Down",  "Left",  "Right", "PgUp",  "PgDn",  "F1",
                                              "F8",    "F9",    "F10",   "F11",   "F12",   "?",     ""};
    static_assert(std::size(after_z) == static_cast<int>(Key::Other) - static_cast<int>(Key::Z));
    const int index = static_cast<int>(key);
    if (key <= Key::Z) return std::string(1, static_cast<char>('A' + index));
    return after_z[index - static_cast<int>(Key::Z) - 1];
}

}  // namespace

bool choose_by_keys(int& chosen, int count, int columns, const UiInput& input) {
    bool decided = false;
    for (const KeyPress& press : input.presses) {
        decided |= press.key == Key::Enter;
        int step = press.key == Key::Down ? columns : press.key == Key::Up ? -columns : 0;
        if (columns > 1 && press.key == Key::Right) step = 1;
        if (columns > 1 && press.key == Key::Left) step = -1;
        if (step == 0 || count == 0) continue;
        if (chosen < 0)
            chosen = step > 0 ? 0 : count - 1;
        else if (columns == 1)
            chosen = (chosen + step + count) % count;
        else if (chosen + step >= 0 && chosen + step < count)
            chosen += step;
    }
    chosen = std::min(chosen, count - 1);
    return decided && chosen >= 0;
}

std::string text_of(KeyPress press) {
    std::string text = press.ctrl ? "Ctrl+" : "";
    if (press.alt) text += "Alt+";
    if (press.shift && press.key != Key::Question) text += "Shift+";  // "?" is itself typed with Shift
    return text + name_of(press.key);
}

namespace {

constexpr std::size_t longest_search = 100;
constexpr int same = 0, at_start = 1, at_word = 2, inside = 3, in_order = 4;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string folded(std::string_view text) {
    std::string plain = with_spaces(text);
    std::transform(plain.begin(), plain.end(), plain.begin(), lower);
    // British and American spellings match each other, even while the word is still being typed.
    constexpr std::pair<std::string_view, std::string_view> spellings[] = {
        {"colou", "colo"}, {"grey", "gray"}, {"alis", "aliz"}, {"centre", "center"}};
    for (const auto& [british, american] : spellings)
        for (std::size_t at = plain.find(british); at != plain.npos; at = plain.find(british))
            plain.replace(at, british.size(), american);
    return plain;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0; }

bool occurs_in_order(std::string_view letters, std::string_view name) {
    for (const char c : name) {
        if (letters.empty()) break;
        if (c == letters.front()) letters.remove_prefix(1);
    }
    return letters.empty();
}

/// Precondition: folded() has been applied to the two texts.
std::optional<int> rank_of(std::string_view text, std::string_view name) {
    if (name == text) return same;
    if (name.starts_with(text)) return at_start;
    bool occurs = false;
    for (std::size_t at = 0; at < name.size(); ++at) {
        if (!is_letter(name[at]) || (at > 0 && is_letter(name[at - 1]))) continue;  // not the start of a word
        const std::string_view rest = name.substr(at);
        if (rest.starts_with(text)) return at_word;
        occurs = occurs || (rest.front() == text.front() && occurs_in_order(text, rest));
    }
    if (name.find(text) != name.npos) return inside;
    return occurs ? std::optional(in_order) : std::nullopt;
}

}  // namespace

std::string with_spaces(std::string_view name) {
    std::string words(name);
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c == '-' || c == '_'; }, ' ');
    for (const std::string_view word : {"sRGB", "NaN", "Phong"}) {
        std::string small(word);
        std::transform(small.begin(), small.end(), small.begin(), lower);
        const auto is_end = [&](std::size_t at) { return at >= words.size() || !is_letter(words[at]); };
        for (std::size_t at = words.find(small); at != words.npos; at = words.find(small, at + 1))
            if (is_end(at - 1) && is_end(at + word.size())) words.replace(at, word.size(), word);
    }
    return words;
}

std::optional<int> match_rank(std::string_view text, std::string_view name) {
    const std::string wanted = folded(text.substr(0, longest_search)), in = folded(name);
    const std::optional<int> whole = rank_of(wanted, in);
    if (whole && *whole < in_order) return whole;
    int worst = same;
    for (std::string_view rest = wanted; !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        rest.remove_prefix(std::min(word.size() + 1, rest.size()));
        if (word.empty()) continue;
        const std::optional<int> rank = rank_of(word, in);
        if (!rank) return whole;
        worst = std::max(worst, *rank);
    }
    return worst;
}

}  // namespace glint
