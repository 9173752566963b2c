#pragma once
// How the picture was looked at, from one day to the next: comparison, scope, false colours, and the views
// that were kept by hand.

#include <vector>

#include "models/scene/camera.h"
#include "ui/views/compare_view.h"
#include "ui/views/debug_view_controls.h"

namespace glint {

struct UiState;

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

}  // namespace glint
