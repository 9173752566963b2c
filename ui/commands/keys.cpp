#include "ui/commands/keys.h"

namespace glint {
namespace {

std::string name_of(Key key) {
    static constexpr const char* after_z[] = {"1",     "2",     "3",     "4",    "pad 0", "pad 1", "pad 3",
                                              "pad 5", "pad 7", "pad .", "Del",  "Esc",   "Enter", "Tab",
                                              "Up",    "Down",  "PgUp",  "PgDn", "F1",    "F8",    "F9",
                                              "F10",   "F11",   "F12",   "?",    ""};
    static_assert(std::size(after_z) == static_cast<int>(Key::Other) - static_cast<int>(Key::Z));
    const int index = static_cast<int>(key);
    if (key <= Key::Z) return std::string(1, static_cast<char>('A' + index));
    return after_z[index - static_cast<int>(Key::Z) - 1];
}

}  // namespace

std::string text_of(KeyPress press) {
    std::string text = press.ctrl ? "Ctrl+" : "";
    if (press.alt) text += "Alt+";
    if (press.shift && press.key != Key::Question) text += "Shift+";  // "?" is typed with Shift
    return text + name_of(press.key);
}

}  // namespace glint
