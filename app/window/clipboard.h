#pragma once
// Text to and from the clipboard. Under X11 a program that pastes asks the one that copied, which may have
// hung or may go away before it has answered. GLFW would wait for it for ever, and the window with it.

#include <memory>
#include <optional>
#include <string>

struct GLFWwindow;

namespace glint {

class Clipboard {
  public:
    explicit Clipboard(GLFWwindow* window);
    ~Clipboard();
    Clipboard(const Clipboard&) = delete;
    Clipboard& operator=(const Clipboard&) = delete;

    /// Makes ImGui copy to this clipboard and paste from it. Precondition: ImGui's backend has begun; this
    /// outlives it.
    void serve_imgui();

    void set(const char* text);
    /// Returns its text, in UTF-8, which lives until the next call; "" where it holds none, null where it
    /// holds one that did not come in time or is longer than 1 MiB.
    [[nodiscard]] const char* text();
    /// Why the last text was null, in words for the user, once; nothing where it was not.
    [[nodiscard]] std::optional<std::string> take_problem();

  private:
    class Connection;

    GLFWwindow* window_;
    std::unique_ptr<Connection> connection_;  // null under Wayland, where GLFW asks
    unsigned long own_ = 0;                   // GLFW's window that owns what was set last
    std::string text_;
    std::optional<std::string> problem_;
};

/// Ends the program `seconds` from now with exit status 0 if it is still there; 0 seconds take that back. For
/// GLFW's own end, which waits for a clipboard manager that may have hung.
void end_within(unsigned seconds);

}  // namespace glint
