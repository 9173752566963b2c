#pragma once
// The lines of the outside view.

#include <imgui.h>

#include "ui/picture/picture_view.h"

namespace glint {

struct OutsideScene {
    const Scene& scene;
    const PictureView& main;  // through which the scene's own camera sees it
    int selected_light = -1, hovered_light = -1;
};

/// How far the view volume is drawn, in depth: a little behind the target, since the far plane may be
/// anywhere.
[[nodiscard]] double drawn_depth(const Camera& camera);

/// How long the drawn axes are, of the camera and of the world.
[[nodiscard]] double axis_length(const Camera& camera);

/// Draws meshes (of large ones some of the edges), the eye, its view volume and axes, the world's axes and
/// the lights, as `view` shows them.
void draw_outside(ImDrawList& list, const PictureView& view, const OutsideScene& what);

}  // namespace glint
