#include "app/window/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cctype>

namespace glint {
namespace {

Key key_of_letter(char letter) {
    if (letter < 'a' || letter > 'z') return Key::Other;
    return static_cast<Key>(static_cast<int>(Key::A) + letter - 'a');
}

/// The letter that the user's layout prints on the key, so that Ctrl+Z is where Z is; 0 for keys without one.
char letter_of(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    if (name != nullptr && name[0] != 0 && name[1] == 0)
        return static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return key >= GLFW_KEY_A && key <= GLFW_KEY_Z ? static_cast<char>('a' + key - GLFW_KEY_A) : '\0';
}

Key key_of(int key, int scancode, int mods) {
    switch (key) {
    case GLFW_KEY_DELETE:
        return Key::Delete;
    case GLFW_KEY_ESCAPE:
        return Key::Escape;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
        return Key::Enter;
    case GLFW_KEY_TAB:
        return Key::Tab;
    case GLFW_KEY_UP:
        return Key::Up;
    case GLFW_KEY_DOWN:
        return Key::Down;
    case GLFW_KEY_LEFT:
        return Key::Left;
    case GLFW_KEY_RIGHT:
        return Key::Right;
    case GLFW_KEY_PAGE_UP:
        return Key::PageUp;
    case GLFW_KEY_PAGE_DOWN:
        return Key::PageDown;
    case GLFW_KEY_F8:
        return Key::F8;
    case GLFW_KEY_F9:
        return Key::F9;
    case GLFW_KEY_F10:
        return Key::F10;
    case GLFW_KEY_KP_0:
        return Key::Pad0;
    case GLFW_KEY_KP_1:
        return Key::Pad1;
    case GLFW_KEY_KP_3:
        return Key::Pad3;
    case GLFW_KEY_KP_5:
        return Key::Pad5;
    case GLFW_KEY_KP_7:
        return Key::Pad7;
    case GLFW_KEY_KP_DECIMAL:
        return Key::PadPoint;
    case GLFW_KEY_F1:
        return Key::F1;
    case GLFW_KEY_F11:
        return Key::F11;
    case GLFW_KEY_F12:
        return Key::F12;
    default:
        break;
    }
    const char letter = letter_of(key, scancode);
    if ((letter == '/' || letter == '?') && (mods & GLFW_MOD_SHIFT) != 0) return Key::Question;
    // Digits by place: some layouts print them only with Shift.
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_4)
        return static_cast<Key>(static_cast<int>(Key::Digit1) + key - GLFW_KEY_1);
    return key_of_letter(letter);
}

WindowInput& input_of(GLFWwindow* window) {
    return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
    if (action == GLFW_RELEASE) return;
    const Key ours = key_of(key, scancode, mods);
    const bool ctrl = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
    const bool shift = (mods & GLFW_MOD_SHIFT) != 0, alt = (mods & GLFW_MOD_ALT) != 0;
    const bool modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
    if (key >= 0 && !modifier) input_of(window).taps.push_back({key, ctrl, shift, alt});
    // Undo, redo and moving through a list repeat while the key is held.
    const bool repeats = ours == Key::Z || ours == Key::Y || ours == Key::Up || ours == Key::Down;
    if (action == GLFW_REPEAT && !repeats) return;
    input_of(window).ui.presses.push_back({ours, ctrl, shift, alt});
}

void on_button(GLFWwindow* window, int button, int action, int /*mods*/) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    // The cursor is not asked for by glfwGetCursorPos: that says where it is by now.
    WindowInput& input = input_of(window);
    input.buttons.push_back({button, action == GLFW_PRESS, input.cursor});
}

void on_cursor(GLFWwindow* window, double x, double y) { input_of(window).cursor = {float(x), float(y)}; }

void on_drop(GLFWwindow* window, int count, const char** paths) {
    for (int i = 0; i < count; ++i) input_of(window).ui.dropped.emplace_back(paths[i]);
}

void on_refresh(GLFWwindow* window) { input_of(window).refresh_asked = true; }

void on_maximize(GLFWwindow* window, int /*maximized*/) { input_of(window).maximize_changed = true; }

void on_close(GLFWwindow* window) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);  // the question about unsaved changes comes first
    input_of(window).ui.close_asked = true;
}

}  // namespace

void collect_input(GLFWwindow* window, WindowInput& input) {
    glfwSetWindowUserPointer(window, &input);
    glfwSetKeyCallback(window, on_key);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetDropCallback(window, on_drop);
    glfwSetWindowRefreshCallback(window, on_refresh);
    glfwSetWindowMaximizeCallback(window, on_maximize);
    glfwSetWindowCloseCallback(window, on_close);
}

void read_held_keys(GLFWwindow* window, UiInput& input) {
    // A key is known by the letter that the keyboard's layout gives it.
    input.axis_held = {};
    input.b_held = false;
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) {
        if (glfwGetKey(window, key) != GLFW_PRESS) continue;
        const char letter = letter_of(key, glfwGetKeyScancode(key));
        input.b_held = input.b_held || letter == 'b';
        if (letter >= 'x' && letter <= 'z') input.axis_held[static_cast<std::size_t>(letter - 'x')] = true;
    }
}

bool feed_keys(GLFWwindow* window, WindowInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    const auto held = [window](int key) { return glfwGetKey(window, key) == GLFW_PRESS; };
    for (const int key : input.shown_down) io.KeysDown[key] = held(key);
    if (!input.shown_down.empty()) {
        io.KeyCtrl = held(GLFW_KEY_LEFT_CONTROL) || held(GLFW_KEY_RIGHT_CONTROL);
        io.KeyShift = held(GLFW_KEY_LEFT_SHIFT) || held(GLFW_KEY_RIGHT_SHIFT);
        io.KeyAlt = held(GLFW_KEY_LEFT_ALT) || held(GLFW_KEY_RIGHT_ALT);
    }
    input.shown_down.clear();
    for (const KeyTap& tap : input.taps) {
        io.KeysDown[tap.key] = true;
        io.KeyCtrl = tap.ctrl, io.KeyShift = tap.shift, io.KeyAlt = tap.alt;
        input.shown_down.push_back(tap.key);
    }
    input.taps.clear();
    return !input.shown_down.empty();
}

bool feed_button(WindowInput& input) {
    // The queue decides the state of three buttons; the backend has set the latest, which may be too new.
    ImGuiIO& io = ImGui::GetIO();
    const bool fed = !input.buttons.empty();
    if (fed) {
        const ButtonEvent event = input.buttons.front();
        input.buttons.pop_front();
        input.down[static_cast<std::size_t>(event.button)] = event.down;
        io.MousePos = {event.at.x, event.at.y};
    }
    for (std::size_t i = 0; i < input.down.size(); ++i) io.MouseDown[i] = input.down[i];
    return fed;
}

}  // namespace glint
