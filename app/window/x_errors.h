#pragma once
// Xlib's answer to an error is to end the program. A program that goes away while it drags a file over the
// window, or while it waits for what it pastes, is such an error (BadWindow): nothing of ours is lost by it.

#include <optional>
#include <string>

namespace glint {

/// Takes the place of Xlib's handlers, where GLFW uses Xlib; does nothing where it does not (Wayland). Call
/// it before events are read, each time: GLFW and drivers put handlers of their own there for a while.
/// `display_gone` is called when the connection to the display breaks, must not talk to the display, and must
/// not return.
void handle_x_errors(void (*display_gone)());

/// What went wrong since the last call, in words for the user; nothing when nothing did.
[[nodiscard]] std::optional<std::string> take_x_error();

}  // namespace glint
