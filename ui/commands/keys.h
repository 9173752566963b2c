#pragma once
// Keys as the window hands them over: no library's codes. Letters are those of the user's keyboard layout.

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
    Pad0, Pad1, Pad3, Pad5, Pad7, PadPoint,  // of the number pad
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
/// Writes it as the window does: "Ctrl+Shift+Z", "pad 5", "?".
[[nodiscard]] std::string text_of(KeyPress press);

/// What arrived since the last frame, beside what ImGui's io holds.
struct UiInput {
    std::vector<KeyPress> presses;
    std::array<bool, 3> axis_held{};   // X, Y, Z are down
    bool b_held = false;               // B is down
    std::vector<std::string> dropped;  // paths of files
    bool close_asked = false;          // the window's own close button
};

/// Arrow keys in a list of so many entries, or in a grid of several columns. `chosen` is -1 before one is
/// chosen. A list goes round, a grid ends. True when Enter has decided upon the chosen one.
[[nodiscard]] bool choose_by_keys(int& chosen, int count, int columns, const UiInput& input);

}  // namespace glint
