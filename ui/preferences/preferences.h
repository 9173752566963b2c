#pragma once
// What the window remembers from one day to the next: theme, columns, its size, how the picture is looked at.
// A small JSON file that anyone may have written anything into.

#include <string>

#include "ui/preferences/view_preferences.h"
#include "ui/shell/layout.h"

namespace glint {

struct Preferences {
    bool dark = true;
    LayoutState layout;
    int width = 0, height = 0;  // of the window, in its own units; 0: as the display suggests
    bool maximized = false;
    ViewPreferences views;
    bool operator==(const Preferences&) const = default;
};

/// As JSON, ending with a newline. What is written reads back equal.
[[nodiscard]] std::string preferences_text(const Preferences& settings);

/// Whatever can be understood of `text`; the rest has its default. Numbers out of their range are brought
/// into it.
[[nodiscard]] Preferences read_preferences(const std::string& text);

}  // namespace glint
