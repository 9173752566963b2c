#pragma once
// The gizmo of the selected object: arrows, rings or boxes, each axis in its colour with its letter.

#include <imgui.h>

#include <optional>

#include "ui/picture/handles/object_drag.h"

namespace glint {

/// `in_hand`: the part that is under the cursor or being dragged.
void draw_object_gizmo(ImDrawList& list, const PictureView& view, const ObjectGizmo& gizmo, GizmoMode mode,
                       std::optional<GizmoPart> in_hand);

}  // namespace glint
