#pragma once
// Xlib's default is to end the program on any error. One such error (BadWindow) is another program that quits
// while it drags a file over the window or waits for what it pastes; nothing of ours is lost by it.

#include <optional>
#include <string>

namespace glint {

/// Replaces Xlib's error handlers where GLFW uses Xlib; does nothing where it does not (Wayland). Call it
/// each time before events are read: GLFW and drivers install handlers of their own for a while.
/// `display_gone` is called when the connection to the display breaks; it must not talk to the display and
/// must not return.
void handle_x_errors(void (*display_gone)());

/// What went wrong since the last call, in words for the user; nothing when nothing did.
[[nodiscard]] std::optional<std::string> take_x_error();

}  // namespace glint
