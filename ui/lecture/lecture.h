#pragma once
// What the window does for a lecture: large type, a clean picture, freeze, pen, a step wedge.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "ui/lecture/step_wedge.h"
#include "ui/picture/pen.h"

namespace glint {

struct UiState;

/// Type and widgets are so many times larger: the smallest type, 13 units, becomes 18.
inline constexpr float projector_scale = 1.4f;

struct LectureState {
    bool projector = false;       // large type, strong contrast
    bool folded_before = false;   // the layout that it found
    std::optional<Scene> frozen;  // shown whatever is edited
    PenState pen;
    WedgeState wedge;
};

/// A word over the picture while it does not show what is edited.
void frozen_badge(ImDrawList& list, const LectureState& lecture, const PictureView& view);

}  // namespace glint
