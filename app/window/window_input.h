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

/// A mouse button going down or up, and where the cursor was at that moment. ImGui's backend reads the cursor
/// once a frame: after a slow frame a press would count where the hand is by then, not where it pressed.
struct ButtonEvent {
    int button = 0;
    bool down = false;
    glm::vec2 at{0};  // window coordinates
};

/// A key of GLFW going down, and what was held with it. ImGui's backend keeps only the state of the moment:
/// what goes down and up within one slow frame would never be seen.
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

/// Collects the events of a window into `input`, which must outlive it. Call before ImGui's backend installs
/// its own callbacks: it calls these on.
void collect_input(GLFWwindow* window, WindowInput& input);

/// Which of X, Y, Z and B are held down now.
void read_held_keys(GLFWwindow* window, UiInput& input);

/// After the backend's new frame and before ImGui's: every key that went down is down for this frame, with
/// what was held with it. True when there was one: it may be up again in the next.
bool feed_keys(GLFWwindow* window, WindowInput& input);

/// After the backend's new frame and before ImGui's: puts the oldest button event into ImGui's io, so that
/// every press and every release has a frame of its own. True when there was one.
bool feed_button(WindowInput& input);

}  // namespace glint
