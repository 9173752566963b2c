#pragma once
// Pictures for the clipboard: GLFW's holds text only, so a tool of the desktop takes them.

#include <string>
#include <vector>

#include "models/problem.h"

namespace glint {

/// The program and its arguments that put a PNG from standard input on the clipboard: `wl-copy` under
/// Wayland, `xclip` under X11, where $PATH has it. Empty when there is none.
[[nodiscard]] std::vector<std::string> clipboard_command();

/// Why there is none, for the one who wants it; empty when there is one.
[[nodiscard]] std::string why_no_clipboard();

/// Puts PNG bytes on the clipboard and waits until the tool has taken them. Not for the window's thread.
[[nodiscard]] Result<std::monostate> copy_png(const std::string& bytes);

}  // namespace glint
