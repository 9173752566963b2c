#pragma once
// A command is an action of a menu item or a key. Each is defined once, as a row of a table of functions;
// menus, keys, the palette, the tool bar and the shortcuts sheet read the rows. The core's rows are in
// commands_*.cpp, a feature's rows are in its folder.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/commands/keys.h"
#include "ui/widgets/shortcut.h"

namespace glint {

struct UiState;

enum class Menu { None, File, Edit, View, Inspect, Compare, Lecture, Help };

/// A command's position in its menu, from top to bottom; within a section the core's commands come first,
/// then those of features in the order of ui/features.cpp. Other: in no menu; only the palette lists it.
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
    bool changes_picture = false;  // draws over or replaces the picture, where hints would be in the way
    bool quiet = false;            // does not change or reveal the scene: allowed during a question
    const char* noun = "";         // name of the switch, if it differs from the command's name
    const char* words = "";        // search terms: Ctrl+K also matches the beginnings of these words
    const char* sets = "";         // the scene value that it sets, as in keys_of_value()
};

/// All commands, in section order.
[[nodiscard]] std::span<const WindowCommand> commands();
[[nodiscard]] const WindowCommand& command(CommandId id);

/// All keys of the command: "Ctrl+Shift+Z or Ctrl+Y".
[[nodiscard]] std::string keys_of(const WindowCommand& command);
/// The reason why the command is disabled now; empty if it is enabled.
[[nodiscard]] std::string why_disabled(const UiState& state, const WindowCommand& command);
[[nodiscard]] inline bool can_run(const UiState& state, const WindowCommand& command) {
    return why_disabled(state, command).empty();
}
/// Whether a switch is on; nothing for other commands.
[[nodiscard]] std::optional<bool> is_on(const UiState& state, const WindowCommand& command);
/// Runs the command if can_run().
void run_command(UiState& state, const WindowCommand& command);
inline void run_command(UiState& state, CommandId id) { run_command(state, command(id)); }

/// Runs the commands of the keys pressed in this frame; Escape ends the innermost active item.
void run_keys(UiState& state, const UiInput& input);

// The core's rows by topic, and the parts of a row. A new command is one new row.

[[nodiscard]] std::vector<WindowCommand> file_commands();
[[nodiscard]] std::vector<WindowCommand> edit_commands();
[[nodiscard]] std::vector<WindowCommand> light_commands();
/// The gizmo's commands for the selected object, and the rest of the edit menu below them.
[[nodiscard]] std::vector<WindowCommand> hand_commands();
[[nodiscard]] std::vector<WindowCommand> camera_commands();
[[nodiscard]] std::vector<WindowCommand> view_commands();
[[nodiscard]] std::vector<WindowCommand> shading_commands();

constexpr bool ctrl = true, shift = true, alt = true;  // modifiers of a KeyPress

/// Returns `reason`; empty if `possible`.
[[nodiscard]] inline std::string unless(bool possible, const char* reason) { return possible ? "" : reason; }
[[nodiscard]] inline std::string unless_busy(bool busy) {
    return unless(!busy, "Another picture is being written");
}
[[nodiscard]] inline std::string unless_drawn(const void* picture) {
    return unless(picture != nullptr, "No picture yet");
}
[[nodiscard]] std::string unless_objects(const UiState& state);

}  // namespace glint
