#pragma once
// The rows of commands(), by what they are about. A new command is one new row.

#include "ui/commands/command.h"

namespace glint {

[[nodiscard]] std::vector<WindowCommand> file_commands();
[[nodiscard]] std::vector<WindowCommand> edit_commands();
/// What a hand on the picture does to the selected object, and what goes on in the edit menu below it.
[[nodiscard]] std::vector<WindowCommand> hand_commands();
[[nodiscard]] std::vector<WindowCommand> camera_commands();
[[nodiscard]] std::vector<WindowCommand> view_commands();
[[nodiscard]] std::vector<WindowCommand> lecture_commands();
[[nodiscard]] std::vector<WindowCommand> shading_commands();

constexpr bool ctrl = true, shift = true, alt = true;  // of a KeyPress

/// `reason` unless it is possible.
[[nodiscard]] inline std::string unless(bool possible, const char* reason) { return possible ? "" : reason; }
[[nodiscard]] inline std::string unless_busy(bool busy) {
    return unless(!busy, "Another picture is being written");
}
[[nodiscard]] inline std::string unless_drawn(const void* picture) {
    return unless(picture != nullptr, "There is no picture yet");
}
[[nodiscard]] std::string unless_objects(const UiState& state);

}  // namespace glint
