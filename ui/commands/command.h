#pragma once
// A command is the action behind a menu item or a key. Each is defined once, as a row of a table of
// functions; menus, keys, the palette, the tool bar and the shortcuts sheet read the rows. The core's rows
// are in commands.cpp, those of a feature in its folder.

#include <imgui.h>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/commands/keys.h"
#include "ui/document/scene_edit.h"
#include "ui/widgets/shortcut.h"

namespace glint {

struct UiState;

enum class Menu { None, File, Edit, View, Inspect, Compare, Lecture, Help };

/// A command's position in its menu, from top to bottom; within a section the core's commands come first,
/// then those of features in the order of ui/features.cpp. Other: not in any menu; only the palette lists it.
enum class Section {
    FileOpen,
    FileSave,
    FilePicture,
    FileQuit,
    Edit,
    ViewCamera,
    ViewWindow,
    InspectQuantity,
    InspectScope,
    InspectPixels,
    InspectDots,
    InspectVectors,
    InspectProbe,
    InspectFind,
    Compare,
    CompareStored,
    ComparePicture,
    LecturePages,
    LecturePredict,
    LectureGames,
    LectureLesson,
    LectureShow,
    LectureAnimate,
    LectureWedge,
    Help,
    Other
};
[[nodiscard]] Menu menu_of(Section section);

struct WindowCommand {
    const char* name = "";
    std::vector<KeyPress> keys = {};
    Section section = Section::Other;
    void (*run)(UiState&) = nullptr;
    bool (*is_on)(const UiState&) = nullptr;                // null: not a switch
    std::string (*why_disabled)(const UiState&) = nullptr;  // null, or an empty result: enabled
    CommandId id = CommandId::None;
    bool line_above = false;       // separator above it in the menu
    bool changes_picture = false;  // draws over or replaces the picture: hints would be in the way
    bool quiet = false;            // does not change or reveal the scene: allowed during a question
    const char* noun = "";         // name of the switch, if it differs from the command's name
    const char* words = "";        // search terms: Ctrl+K also matches the start of each of these words
    const char* sets = "";         // the value in the scene that it sets, as in keys_of_value()
};

/// All commands, in section order.
[[nodiscard]] std::span<const WindowCommand> commands();
[[nodiscard]] const WindowCommand& command(CommandId id);

/// Returns all keys of the command: "Ctrl+Shift+Z or Ctrl+Y".
[[nodiscard]] std::string keys_of(const WindowCommand& command);
/// Returns why the command is currently disabled; empty if it is enabled.
[[nodiscard]] std::string why_disabled(const UiState& state, const WindowCommand& command);
[[nodiscard]] inline bool can_run(const UiState& state, const WindowCommand& command) {
    return why_disabled(state, command).empty();
}
/// Returns whether a switch is on; nullopt for other commands.
[[nodiscard]] std::optional<bool> is_on(const UiState& state, const WindowCommand& command);
/// Runs the command if can_run() is true.
void run_command(UiState& state, const WindowCommand& command);
inline void run_command(UiState& state, CommandId id) { run_command(state, command(id)); }

/// Runs the commands of the keys pressed in this frame; Escape ends the innermost active item.
void run_keys(UiState& state, const UiInput& input);

// The core's rows by topic, and helpers for writing a row. Adding a command means adding one row.

[[nodiscard]] std::vector<WindowCommand> file_commands();
[[nodiscard]] std::vector<WindowCommand> edit_commands();
[[nodiscard]] std::vector<WindowCommand> light_commands();
/// The gizmo's commands for the selected object, and the rest of the edit menu below them.
[[nodiscard]] std::vector<WindowCommand> hand_commands();
[[nodiscard]] std::vector<WindowCommand> camera_commands();
[[nodiscard]] std::vector<WindowCommand> view_commands();
[[nodiscard]] std::vector<WindowCommand> shading_commands();

constexpr bool ctrl = true, shift = true, alt = true;  // modifiers of a KeyPress

/// Returns `reason`, or an empty string if `possible`.
[[nodiscard]] inline std::string unless(bool possible, const char* reason) { return possible ? "" : reason; }
[[nodiscard]] inline std::string unless_busy(bool busy) {
    return unless(!busy, "Another picture is being written");
}
[[nodiscard]] inline std::string unless_drawn(const void* picture) {
    return unless(picture != nullptr, "No picture yet");
}
[[nodiscard]] std::string unless_objects(const UiState& state);

// The menus, the shortcuts sheet and the palette, all built from the table of commands.

struct UiState;
struct UiInput;

/// An entry of the palette.
struct PaletteEntry {
    std::string name, group;  // "Phong shading", "Action": the shown name, and the kind of entry
    std::string keys;         // shortcut, or empty
    std::string refused;      // the reason why it is disabled; empty if it is enabled
    std::function<void(UiState&)> run;
    std::string words = "";  // search terms: the start of each of these words matches too
    bool quiet = false;      // allowed during a question
};

struct PaletteState {
    bool open = false;
    bool takes_keyboard = false;  // request for the next frame: focus the text field
    std::string text;
    int chosen = -1;  // index in the matches; -1: none, until the user types or presses an arrow key
    std::vector<PaletteEntry> entries;
    std::vector<int> matches;          // entries that match the text
    ItemCounts made_for;               // scene that the entries' light and object numbers refer to
    float width = 0;                   // required by its entries
    bool has_keyboard = false;         // whether the text field had focus in the previous frame
    std::vector<ImWchar> typed_ahead;  // letters typed before the text field has focus
};

/// Draws the menus. Call it between ImGui::BeginMenuBar() and EndMenuBar().
void menu_bar(UiState& state);

/// Draws the sheet of keys and mouse actions (F1 or ?) while it is open.
void shortcuts_sheet(UiState& state);

// The palette (Ctrl+K) finds every action of the window from a few typed letters.

/// Lists all actions that are possible in this state: commands, fields of the scene, choices and switches of
/// shading and display, mistakes, presets for the selected object, lights to switch on or off, items to
/// select and scenes to open.
[[nodiscard]] std::vector<PaletteEntry> palette_entries(UiState& state);

/// Adds the entries generated from the rows of models/fields/scene_fields.h.
void add_field_entries(std::vector<PaletteEntry>& entries, const UiState& state);

/// Returns the indices of the matching entries, best first, ties in table order. An empty text matches all.
[[nodiscard]] std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries,
                                               const std::string& text);

void open_palette(UiState& state);
void palette(UiState& state, const UiInput& input);

// Matches typed search text against names. Does not draw.

/// Returns the rank of a match between `text` and `name`; lower is better: 0 if they are equal, 1 if the name
/// begins with the text, 2 if a word of the name does, 3 if the name contains it, 4 if the name contains the
/// text's letters in the same order and the first of them begins a word. Otherwise each word of the text is
/// matched by itself, and the worst rank counts. Returns nullopt if a word does not match. Ignores the case
/// of ASCII letters; '-' and '_' match spaces. Only the first 100 bytes of the text count.
[[nodiscard]] std::optional<int> match_rank(std::string_view text, std::string_view name);

/// Replaces the separators in a name from a file or a command with spaces: "lit_in_srgb" becomes "lit in
/// sRGB".
[[nodiscard]] std::string with_spaces(std::string_view name);

}  // namespace glint
