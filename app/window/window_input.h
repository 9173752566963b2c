#pragma once
// Converts GLFW's events to the input of ui/ and ImGui: keys, files, and mouse buttons in order of arrival.
// ImGui 1.87 has such a queue (AddKeyEvent, AddMouseButtonEvent); Debian 12 ships 1.86.

#include <array>
#include <deque>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ui/commands/keys.h"

struct GLFWwindow;

namespace glint {

/// A mouse button that went down or up, and the position of the cursor at that moment. ImGui's backend reads
/// the cursor once a frame: after a slow frame the cursor is no longer where the button was pressed.
struct ButtonEvent {
    int button = 0;
    bool down = false;
    glm::vec2 at{0};  // window coordinates
};

/// The modifiers held with a key.
struct Modifiers {
    bool ctrl = false, shift = false, alt = false;
    bool operator==(const Modifiers&) const = default;
};

/// A key that went down or repeats, the modifiers held with it, and the text that it types. ImGui's backend
/// reads only the current state: it would miss a key that goes down and up within one slow frame.
struct KeyEvent {
    int key = -1;                   // GLFW's key code; -1: only text
    bool repeats = false;           // the key is held down
    std::optional<KeyPress> press;  // the key press as ui/ gets it
    Modifiers with;
    std::u32string text;
};

using InputEvent = std::variant<KeyEvent, ButtonEvent>;

struct WindowInput {
    UiInput ui;
    glm::vec2 cursor{0};             // position at the last event
    std::deque<InputEvent> waiting;  // not yet passed to ImGui, in order of arrival
    int frames_to_open = 0;          // frames until a field or dialog opened by the last event has focus
    std::array<bool, 3> down{};      // buttons as passed to ImGui: left, right, middle
    bool refresh_asked = false;      // the display has lost the window's pixels
    bool maximize_changed = true;    // also true until the window's state is known
    std::vector<int> shown_down;     // keys passed on in the last frame: released unless still held
};

/// Collects the events of a window into `input`, which must outlive it. Call this before ImGui's backend
/// installs its own callbacks, which then call these.
void collect_input(GLFWwindow* window, WindowInput& input);

/// Collects typed text in place of ImGui's backend. Call this after the backend has installed its callbacks.
void collect_text(GLFWwindow* window);

/// Reads which of X, Y, Z and B are held down now.
void read_held_keys(GLFWwindow* window, UiInput& input);

/// Passes the oldest events to ImGui and `input.ui`: one button event, or keys and text up to the first key
/// that may open a field or a dialog. Later text waits until the field or dialog is open, even in slow
/// frames. Returns true if frames must follow at once. Call this between the backend's new frame and ImGui's.
bool feed_input(GLFWwindow* window, WindowInput& input);

}  // namespace glint
