#pragma once
// What one frame of the viewport works on, and which keys the other hand holds.

#include <array>

#include "renderer/renderer.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/handles/object_drag.h"
#include "ui/picture/picture_view.h"

namespace glint {

struct ViewportFrame {
    Scene& scene;
    Selection& selection;
    const Renderer* renderer = nullptr;  // of the last picture; null before the first
    PictureView view;
    GizmoMode gizmo = GizmoMode::Move;  // of the selected object
    std::optional<glm::dvec3> pivot{};  // what Rotate turns it about, world coordinates; else its origin
};

struct HandKeys {
    bool shift = false, ctrl = false, alt = false;
    std::array<bool, 3> axis{};  // X, Y, Z
};

}  // namespace glint
