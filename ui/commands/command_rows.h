#pragma once
// The rows of commands(), grouped by topic. A new command is one new row.

#include "ui/commands/command.h"

namespace glint {

[[nodiscard]] std::vector<WindowCommand> file_commands();
[[nodiscard]] std::vector<WindowCommand> edit_commands();
/// Lists what the mouse does to the selected object by its gizmo, and the rest of the edit menu below it.
[[nodiscard]] std::vector<WindowCommand> hand_commands();
[[nodiscard]] std::vector<WindowCommand> camera_commands();
/// Lists those of the menu View, compare_commands() among them.
[[nodiscard]] std::vector<WindowCommand> view_commands();
[[nodiscard]] std::vector<WindowCommand> compare_commands();
[[nodiscard]] std::vector<WindowCommand> lecture_commands();
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
