#pragma once
// From GLFW's events to what ui/ and ImGui know: keys, files, and mouse buttons in the order in which they
// came.

#include <array>
#include <deque>
#include <glm/vec2.hpp>

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

struct WindowInput {
    UiInput ui;
    glm::vec2 cursor{0};              // as the events so far say
    std::deque<ButtonEvent> buttons;  // not yet seen by ImGui
    std::array<bool, 3> down{};       // as ImGui has seen them: left, right, middle
};

/// Collects the events of a window into `input`, which must outlive it. Call before ImGui's backend installs
/// its own callbacks: it calls these on.
void collect_input(GLFWwindow* window, WindowInput& input);

/// Which of X, Y, Z and B are held down now.
void read_held_keys(GLFWwindow* window, UiInput& input);

/// After the backend's new frame and before ImGui's: puts the oldest button event into ImGui's io, so that
/// every press and every release has a frame of its own. True when there was one.
bool feed_button(WindowInput& input);

}  // namespace glint
