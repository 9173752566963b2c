#pragma once
// Keys, independent of the window library's key codes. Letters follow the user's keyboard layout.

#include <array>
#include <string>
#include <vector>

namespace glint {

// clang-format off
enum class Key {
    A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    Digit1,
    Digit2,
    Digit3,
    Digit4,
    Pad0, Pad1, Pad3, Pad5, Pad7, PadPoint,  // on the numeric keypad
    Delete,
    Escape,
    Enter,
    Tab,
    Up,
    Down,
    Left,
    Right,
    PageUp,
    PageDown,
    F1,
    F8,
    F9,
    F10,
    F11,
    F12,
    Question,
    Other
};
// clang-format on

struct KeyPress {
    Key key = Key::Other;
    bool ctrl = false, shift = false, alt = false;
    bool operator==(const KeyPress&) const = default;
    [[nodiscard]] bool is_alone() const { return !ctrl && !shift && !alt; }
};
/// Returns the key as shown in the window: "Ctrl+Shift+Z", "pad 5", "?".
[[nodiscard]] std::string text_of(KeyPress press);

/// Input since the last frame, in addition to ImGui's io.
struct UiInput {
    std::vector<KeyPress> presses;
    std::array<bool, 3> axis_held{};   // X, Y, Z are down
    bool b_held = false;               // B is down
    std::vector<std::string> dropped;  // file paths
    bool close_asked = false;          // the window's close button was clicked
};

/// Moves `chosen` with the arrow keys in a list of `count` entries, or in a grid if `columns` is above 1.
/// `chosen` is -1 before the first choice. A list wraps around, a grid does not. Returns true if Enter
/// confirms the chosen entry.
[[nodiscard]] bool choose_by_keys(int& chosen, int count, int columns, const UiInput& input);

}  // namespace glint
