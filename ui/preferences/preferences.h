#pragma once
// What the window remembers from one day to the next: theme, columns, its size, how the picture is looked at.
// It stands in a small JSON file, which is read as untrusted.

#include <string>
#include <vector>

#include "models/scene/camera.h"
#include "ui/shell/layout.h"
#include "ui/views/compare_view.h"
#include "ui/views/debug_view_controls.h"

namespace glint {

struct UiState;

/// How the picture is looked at, and the views that were kept by hand.
struct ViewPreferences {
    CompareChoice compare;  // without its B: a scene is not a preference
    DebugView debug_view = DebugView::Picture;
    bool over_range = false, dots = false, needles = false;
    glm::dvec2 scope_from{0.02, 0.5}, scope_to{0.98, 0.5};  // shares of the picture's size
    bool scope_channels = false, scope_eye = false;
    std::vector<Camera> kept;  // at most most_views
    bool operator==(const ViewPreferences&) const = default;
};

[[nodiscard]] ViewPreferences views_to_remember(const UiState& state);
/// Looks at the picture that way; a stored B stays.
void recall_views(UiState& state, const ViewPreferences& memory);

struct Preferences {
    bool dark = true;
    LayoutState layout;
    int width = 0, height = 0;  // of the window, in its own units; 0: as the display suggests
    bool maximized = false;
    ViewPreferences views;
    bool operator==(const Preferences&) const = default;
};

/// As JSON, ending with a newline. What is written reads back equal.
[[nodiscard]] std::string preferences_text(const Preferences& preferences);

/// Reads untrusted JSON: invalid or missing members keep their defaults, and numbers out of their range are
/// brought into it.
[[nodiscard]] Preferences read_preferences(const std::string& text);

}  // namespace glint
