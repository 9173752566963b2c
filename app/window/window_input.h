#pragma once
// From GLFW's events to what ui/ and ImGui know: keys, files, and mouse buttons in the order in which they
// came.

#include <array>
#include <deque>
#include <glm/vec2.hpp>
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

/// A key (GLFW's number) that went down, and the modifiers held with it. ImGui's backend reads only the
/// current state: it would miss a key that goes down and up within one slow frame.
struct KeyTap {
    int key = 0;
    bool ctrl = false, shift = false, alt = false;
};

struct WindowInput {
    UiInput ui;
    glm::vec2 cursor{0};              // as the events so far say
    std::deque<ButtonEvent> buttons;  // not yet seen by ImGui
    std::array<bool, 3> down{};       // as ImGui has seen them: left, right, middle
    std::vector<KeyTap> taps;         // keys that went down since the last frame
    bool refresh_asked = false;       // the display lost what was shown
    bool maximize_changed = true;     // or it is not known yet whether the window is maximized
    std::vector<int> shown_down;      // keys of the last frame's taps: up again unless they are held
};

/// Collects the events of a window into `input`, which must outlive it. Call this before ImGui's backend
/// installs its own callbacks, which then call these.
void collect_input(GLFWwindow* window, WindowInput& input);

/// Which of X, Y, Z and B are held down now.
void read_held_keys(GLFWwindow* window, UiInput& input);

/// Call this between the backend's new frame and ImGui's. It reports every key that went down as down for
/// this frame, with its modifiers. True if there was one: it may be up again in the next frame.
bool feed_keys(GLFWwindow* window, WindowInput& input);

/// Call this between the backend's new frame and ImGui's. It passes on the oldest button event to ImGui's io,
/// so that every press and every release has a frame of its own. True if there was one.
bool feed_button(WindowInput& input);

}  // namespace glint
