#pragma once
// What the window does for a lecture: large type, a clean picture, freeze, pen, the scenes of a folder one by
// one, a step wedge. One place for ui.cpp and actions.cpp to call.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "ui/lecture/step_wedge.h"
#include "ui/picture/pen.h"

namespace glint {

struct UiState;
enum class Action;

/// Type and widgets are so many times larger: the smallest type, 13 units, becomes 18.
inline constexpr float projector_scale = 1.4f;

struct LectureState {
    bool projector = false;       // large type, strong contrast
    bool folded_before = false;   // the layout that it found
    std::optional<Scene> frozen;  // shown whatever is edited
    PenState pen;
    WedgeState wedge;
};

/// The part of run_action(), why_not() and is_on() that is about lectures.
void run_lecture_action(UiState& state, Action action);
[[nodiscard]] std::string lecture_why_not(const UiState& state, Action action);
[[nodiscard]] std::optional<bool> lecture_is_on(const UiState& state, Action action);

/// Escape: puts away what is in hand. False when there is nothing.
bool leave_lecture_tool(UiState& state);

/// At the end of a frame: what is frozen is shown in the next one.
void keep_frozen(UiState& state);

/// A word over the picture while it does not show what is edited.
void frozen_badge(ImDrawList& list, const LectureState& lecture, const PictureView& view);

}  // namespace glint
