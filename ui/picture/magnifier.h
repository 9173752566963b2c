#pragma once
// Enlarges the picture without redrawing it, until each pixel is a square with its number in it. Lecture:
// "Gouraud Shading" (scanlines), "Shading Artifacts" (silhouettes).

#include <imgui.h>

#include <glm/vec2.hpp>

#include "ui/picture/screen.h"
#include "ui/picture/tool.h"
#include "ui/widgets/area.h"

namespace glint {

struct MagnifierState {
    // 1, 2, 4 ... 64. A picture pixel is `zoom` window pixels wide, times the scale of the type, rounded up.
    int zoom = 1;
    glm::dvec2 centre{0.5};  // the point shown at the centre, as a fraction of the picture's size
};
inline constexpr int max_zoom = 64, usual_zoom = 32;

/// Enlarges the picture's rectangle in the window about the centre of `area` so that it still covers `area`.
void magnify(PictureView& view, const Rect& area, const MagnifierState& magnifier);

/// Changes the zoom; the pixel at `share` does not move in the window.
void zoom_about(MagnifierState& magnifier, int zoom, glm::dvec2 share);

extern const Tool magnifier_tool;

/// Draws squares, their numbers, edges between faces, and the scan line and polygon of the picked pixel;
/// draws nothing while pixels are too small.
void draw_big_pixels(ImDrawList& list, UiState& state, const PictureView& view);

}  // namespace glint
