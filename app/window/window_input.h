#pragma once
// From GLFW's events to what ui/ and ImGui know: keys, files, and mouse buttons in the order in which they
// came.

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

/// A mouse button that went down or up, and where the cursor was at that moment. ImGui's backend reads the
/// cursor once a frame: after a slow frame a press would land where the cursor is by then.
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
    int key = -1;                   // GLFW's number; -1: only the text is told to ImGui
    bool repeats = false;           // it is held
    std::optional<KeyPress> press;  // for ui/
    Modifiers with;
    std::u32string text;
};

using InputEvent = std::variant<KeyEvent, ButtonEvent>;

struct WindowInput {
    UiInput ui;
    glm::vec2 cursor{0};             // as the events so far say
    std::deque<InputEvent> waiting;  // not yet seen by ImGui, in the order in which they came
    int frames_to_open = 0;          // frames in which what the last event opens may come to take the keys
    std::array<bool, 3> down{};      // as ImGui has seen them: left, right, middle
    bool refresh_asked = false;      // the display lost what was shown
    bool maximize_changed = true;    // or it is not known yet whether the window is maximized
    std::vector<int> shown_down;     // keys told in the last frame: up again unless they are held
};

/// Collects the events of a window into `input`, which must outlive it. Call this before ImGui's backend
/// installs its own callbacks, which then call these.
void collect_input(GLFWwindow* window, WindowInput& input);

/// Collects the text that is typed, too, in the place of ImGui's backend. Call this after it.
void collect_text(GLFWwindow* window);

/// Which of X, Y, Z and B are held down now.
void read_held_keys(GLFWwindow* window, UiInput& input);

/// Call this between the backend's new frame and ImGui's. It tells ImGui and `input.ui` the oldest events:
/// one of a button, or keys and text up to the first that may open a field or a dialog. What is typed behind
/// it waits until that is open, however slow the frames are. True if frames have to follow at once.
bool feed_input(GLFWwindow* window, WindowInput& input);

}  // namespace glint
