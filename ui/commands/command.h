#pragma once
// A command is anything that a menu item or a key does, defined once: one row of a table with the functions
// that do it. Menus, keys, the palette, the tool bar and the sheet of shortcuts read the rows. The core's
// rows are in commands_*.cpp, those of a feature in its folder.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/commands/keys.h"
#include "ui/widgets/shortcut.h"

namespace glint {

struct UiState;

enum class Menu { None, File, Edit, View, Lecture, Help };

/// Where a command is in its menu, from top to bottom; within a section the core's commands come first, then
/// those of features in the order of ui/features.cpp. Other: it is in no menu, and the palette finds it.
enum class Section {
    FileOpen,
    FileSave,
    FilePicture,
    FileQuit,
    Edit,
    ViewCamera,
    ViewScope,
    ViewVectors,
    ViewProbe,
    ViewQuantity,
    ViewPixels,
    ViewDots,
    ViewCompare,
    ViewStored,
    ViewWindow,
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
    bool (*is_on)(const UiState&) = nullptr;                // null: it is not a switch
    std::string (*why_disabled)(const UiState&) = nullptr;  // null, or an empty reason: it can be done
    CommandId id = CommandId::None;
    bool line_above = false;       // in the menu
    bool changes_picture = false;  // it draws over or replaces the picture, where hints would be in the way
    bool quiet = false;            // it neither changes nor reveals the scene: allowed while a question waits
    const char* noun = "";         // what is on or off, where that is not the name
    const char* words = "";        // what it is about: Ctrl+K finds it by the beginnings of these words, too
    const char* sets = "";         // what it sets of the scene, as keys_of_value() takes it
};

/// All commands, in the order of sections.
[[nodiscard]] std::span<const WindowCommand> commands();
[[nodiscard]] const WindowCommand& command(CommandId id);

/// All its keys: "Ctrl+Shift+Z or Ctrl+Y".
[[nodiscard]] std::string keys_of(const WindowCommand& command);
/// Why it cannot be done now; empty when it can.
[[nodiscard]] std::string why_disabled(const UiState& state, const WindowCommand& command);
[[nodiscard]] inline bool can_run(const UiState& state, const WindowCommand& command) {
    return why_disabled(state, command).empty();
}
/// Whether what the command switches is on; nothing when it is not a switch.
[[nodiscard]] std::optional<bool> is_on(const UiState& state, const WindowCommand& command);
/// Does it, if can_run().
void run_command(UiState& state, const WindowCommand& command);
inline void run_command(UiState& state, CommandId id) { run_command(state, command(id)); }

/// Runs the commands of the keys that came with this frame; Escape leaves the innermost thing.
void run_keys(UiState& state, const UiInput& input);

// The rows of the core, by topic, and what rows are made of. A new command is one new row.

[[nodiscard]] std::vector<WindowCommand> file_commands();
[[nodiscard]] std::vector<WindowCommand> edit_commands();
/// Lists what the mouse does to the selected object by its gizmo, and the rest of the edit menu below it.
[[nodiscard]] std::vector<WindowCommand> hand_commands();
[[nodiscard]] std::vector<WindowCommand> camera_commands();
[[nodiscard]] std::vector<WindowCommand> view_commands();
[[nodiscard]] std::vector<WindowCommand> shading_commands();

constexpr bool ctrl = true, shift = true, alt = true;  // of a KeyPress

/// Returns `reason`; empty if `possible`.
[[nodiscard]] inline std::string unless(bool possible, const char* reason) { return possible ? "" : reason; }
[[nodiscard]] inline std::string unless_busy(bool busy) {
    return unless(!busy, "Another picture is being written");
}
[[nodiscard]] inline std::string unless_drawn(const void* picture) {
    return unless(picture != nullptr, "There is no picture yet");
}
[[nodiscard]] std::string unless_objects(const UiState& state);

}  // namespace glint
