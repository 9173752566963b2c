#include "app/window/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace glint {
namespace {

Key key_of_letter(char letter) {
    if (letter < 'a' || letter > 'z') return Key::Other;
    return static_cast<Key>(static_cast<int>(Key::A) + letter - 'a');
}

/// Returns the key's letter in the user's layout; 0 for keys without one.
char letter_of(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    if (name != nullptr && name[0] != 0 && name[1] == 0)
        return static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return key >= GLFW_KEY_A && key <= GLFW_KEY_Z ? static_cast<char>('a' + key - GLFW_KEY_A) : '\0';
}

constexpr std::array<std::pair<int, Key>, 27> fixed_keys{{
    {GLFW_KEY_DELETE, Key::Delete},
    {GLFW_KEY_ESCAPE, Key::Escape},
    {GLFW_KEY_ENTER, Key::Enter},
    {GLFW_KEY_KP_ENTER, Key::Enter},
    {GLFW_KEY_TAB, Key::Tab},
    {GLFW_KEY_UP, Key::Up},
    {GLFW_KEY_DOWN, Key::Down},
    {GLFW_KEY_LEFT, Key::Left},
    {GLFW_KEY_RIGHT, Key::Right},
    {GLFW_KEY_PAGE_UP, Key::PageUp},
    {GLFW_KEY_PAGE_DOWN, Key::PageDown},
    {GLFW_KEY_F1, Key::F1},
    {GLFW_KEY_F8, Key::F8},
    {GLFW_KEY_F9, Key::F9},
    {GLFW_KEY_F10, Key::F10},
    {GLFW_KEY_F11, Key::F11},
    {GLFW_KEY_F12, Key::F12},
    {GLFW_KEY_KP_0, Key::Pad0},
    {GLFW_KEY_KP_1, Key::Pad1},
    {GLFW_KEY_KP_3, Key::Pad3},
    {GLFW_KEY_KP_5, Key::Pad5},
    {GLFW_KEY_KP_7, Key::Pad7},
    {GLFW_KEY_KP_DECIMAL, Key::PadPoint},
    // Identified by position: some layouts type digits only with Shift.
    {GLFW_KEY_1, Key::Digit1},
    {GLFW_KEY_2, Key::Digit2},
    {GLFW_KEY_3, Key::Digit3},
    {GLFW_KEY_4, Key::Digit4},
}};

Key key_of(int key, int scancode, int mods) {
    const char letter = letter_of(key, scancode);
    if ((letter == '/' || letter == '?') && (mods & GLFW_MOD_SHIFT) != 0) return Key::Question;
    for (const auto& [number, ours] : fixed_keys)
        if (number == key) return ours;
    return key_of_letter(letter);
}

/// The keys of the number pad without NumLock. GLFW identifies them by their digit with or without NumLock.
constexpr std::array<std::pair<int, int>, 9> pad_moves{{{GLFW_KEY_KP_7, GLFW_KEY_HOME},
                                                        {GLFW_KEY_KP_8, GLFW_KEY_UP},
                                                        {GLFW_KEY_KP_9, GLFW_KEY_PAGE_UP},
                                                        {GLFW_KEY_KP_4, GLFW_KEY_LEFT},
                                                        {GLFW_KEY_KP_6, GLFW_KEY_RIGHT},
                                                        {GLFW_KEY_KP_1, GLFW_KEY_END},
                                                        {GLFW_KEY_KP_2, GLFW_KEY_DOWN},
                                                        {GLFW_KEY_KP_3, GLFW_KEY_PAGE_DOWN},
                                                        {GLFW_KEY_KP_DECIMAL, GLFW_KEY_DELETE}}};

WindowInput& input_of(GLFWwindow* window) {
    return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
    const bool modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
    if (action == GLFW_RELEASE || modifier) return;
    // In a field these keys move the cursor; over the picture they turn the view, with or without NumLock.
    if (ImGui::GetIO().WantTextInput && (mods & GLFW_MOD_NUM_LOCK) == 0)
        for (const auto& [pad, move] : pad_moves)
            if (key == pad) key = move;
    KeyEvent event;
    event.key = key;
    event.with = {(mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0, (mods & GLFW_MOD_SHIFT) != 0,
                  (mods & GLFW_MOD_ALT) != 0};
    event.repeats = action == GLFW_REPEAT;
    const Key ours = key_of(key, scancode, mods);
    // Undo, redo, and moving through a list or over the picture's pixels repeat while the key is held.
    const bool is_arrow = ours >= Key::Up && ours <= Key::Right && !event.with.alt;
    const bool may_repeat = ours == Key::Z || ours == Key::Y || is_arrow;
    if (!event.repeats || may_repeat)
        event.press = KeyPress{ours, event.with.ctrl, event.with.shift, event.with.alt};
    input_of(window).waiting.emplace_back(std::move(event));
}

/// GLFW calls this right after the key event of the key that types the letter. If several keys produce one
/// letter, the letter arrives without a key event.
void on_text(GLFWwindow* window, unsigned int letter) {
    std::deque<InputEvent>& waiting = input_of(window).waiting;
    auto* key = waiting.empty() ? nullptr : std::get_if<KeyEvent>(&waiting.back());
    if (key == nullptr || !key->text.empty()) key = &std::get<KeyEvent>(waiting.emplace_back(KeyEvent{}));
    key->text += static_cast<char32_t>(letter);
}

void on_button(GLFWwindow* window, int button, int action, int /*mods*/) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    // Not glfwGetCursorPos, which returns the current position of the cursor.
    WindowInput& input = input_of(window);
    input.waiting.emplace_back(ButtonEvent{button, action == GLFW_PRESS, input.cursor});
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
    glfwSetInputMode(window, GLFW_LOCK_KEY_MODS, GLFW_TRUE);
    glfwSetKeyCallback(window, on_key);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetDropCallback(window, on_drop);
    glfwSetWindowRefreshCallback(window, on_refresh);
    glfwSetWindowMaximizeCallback(window, on_maximize);
    glfwSetWindowCloseCallback(window, on_close);
}

void collect_text(GLFWwindow* window) { glfwSetCharCallback(window, on_text); }

void read_held_keys(GLFWwindow* window, UiInput& input) {
    // A key is identified by the letter that the keyboard layout assigns to it.
    input.axis_held = {};
    input.b_held = false;
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) {
        if (glfwGetKey(window, key) != GLFW_PRESS) continue;
        const char letter = letter_of(key, glfwGetKeyScancode(key));
        input.b_held = input.b_held || letter == 'b';
        if (letter >= 'x' && letter <= 'z') input.axis_held[static_cast<std::size_t>(letter - 'x')] = true;
    }
}

namespace {

/// The number of frames until a field or dialog opened by a key has the keyboard focus: it opens in the first
/// frame and gets the focus in the second or third.
constexpr int frames_to_open = 3;

bool is_down(GLFWwindow* window, int key) { return glfwGetKey(window, key) == GLFW_PRESS; }

/// Releases the keys that were down for ImGui in the last frame and no longer are. A key whose press is still
/// in the queue is not down yet.
void show_held_keys(GLFWwindow* window, WindowInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : input.shown_down) io.KeysDown[key] = is_down(window, key);
    if (!input.shown_down.empty()) {
        io.KeyCtrl = is_down(window, GLFW_KEY_LEFT_CONTROL) || is_down(window, GLFW_KEY_RIGHT_CONTROL);
        io.KeyShift = is_down(window, GLFW_KEY_LEFT_SHIFT) || is_down(window, GLFW_KEY_RIGHT_SHIFT);
        io.KeyAlt = is_down(window, GLFW_KEY_LEFT_ALT) || is_down(window, GLFW_KEY_RIGHT_ALT);
    }
    for (const InputEvent& event : input.waiting)
        if (const auto* key = std::get_if<KeyEvent>(&event); key != nullptr && key->key >= 0 && !key->repeats)
            io.KeysDown[key->key] = false;
}

/// Whether the key may open a field or a dialog, or move to another field. Excludes keys that are pressed
/// many times a second: each press would cost several frames for nothing.
bool may_open(const KeyEvent& event) {
    if (event.repeats || !event.press) return false;
    switch (event.press->key) {
    case Key::Tab:
    case Key::Enter:
    case Key::Escape:
    case Key::Question:
    case Key::F1:
    case Key::F8:
    case Key::F9:
    case Key::F10:
    case Key::F11:
    case Key::F12:
        return true;
    case Key::A:  // select all, copy, paste and cut in a field; undo and redo
    case Key::C:
    case Key::V:
    case Key::X:
    case Key::Y:
    case Key::Z:
        return false;
    default:
        return event.with.ctrl && event.text.empty();
    }
}

void pass_on(WindowInput& input, const KeyEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    if (event.key >= 0) {
        io.KeysDown[event.key] = true;
        io.KeyCtrl = event.with.ctrl, io.KeyShift = event.with.shift, io.KeyAlt = event.with.alt;
        input.shown_down.push_back(event.key);
    }
    for (const char32_t letter : event.text) io.AddInputCharacter(letter);
    if (event.press) input.ui.presses.push_back(*event.press);
}

/// Passes keys and text on to ImGui and ui/. `before`: the keys that were down in the last frame.
void feed_keys(WindowInput& input, const std::vector<int>& before) {
    ImGuiIO& io = ImGui::GetIO();
    std::optional<Modifiers> with;
    while (!input.waiting.empty() && input.frames_to_open == 0) {
        const auto* event = std::get_if<KeyEvent>(&input.waiting.front());
        if (event == nullptr) return;
        // ImGui knows one set of modifiers per frame, and a key must be released before it can be pressed
        // again.
        if (with && !(*with == event->with)) return;
        const auto has = [event](const std::vector<int>& keys) {
            return std::find(keys.begin(), keys.end(), event->key) != keys.end();
        };
        if (event->text.empty() && !event->repeats && has(input.shown_down)) return;
        if (event->text.empty() && !event->repeats && has(before)) {
            io.KeysDown[event->key] = false;
            return;
        }
        with = event->with;
        pass_on(input, *event);
        if (may_open(*event)) input.frames_to_open = frames_to_open;
        input.waiting.pop_front();
    }
}

/// Passes on the press or release of a mouse button. Each of them gets a frame of its own.
void feed_button(WindowInput& input) {
    const ButtonEvent event = std::get<ButtonEvent>(input.waiting.front());
    input.waiting.pop_front();
    input.down[static_cast<std::size_t>(event.button)] = event.down;
    ImGui::GetIO().MousePos = {event.at.x, event.at.y};
    input.frames_to_open = frames_to_open;
}

}  // namespace

bool feed_input(GLFWwindow* window, WindowInput& input) {
    const bool had_any = !input.waiting.empty();
    show_held_keys(window, input);
    const std::vector<int> before = std::exchange(input.shown_down, {});
    const bool is_button = had_any && std::holds_alternative<ButtonEvent>(input.waiting.front());
    if (is_button) {
        feed_button(input);
    } else {
        if (input.frames_to_open > 0) --input.frames_to_open;
        feed_keys(input, before);
    }
    // The queue determines the state of three buttons: the backend has set the current state, which may be
    // newer.
    for (std::size_t i = 0; i < input.down.size(); ++i) ImGui::GetIO().MouseDown[i] = input.down[i];
    return had_any || !input.shown_down.empty();
}

}  // namespace glint
