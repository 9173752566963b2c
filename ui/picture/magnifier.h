#pragma once
// The magnifier enlarges the picture as it is, without drawing it again, until each pixel is a square with
// its number in it. Lecture: "Gouraud Shading" (scanlines), "Shading Artifacts" (silhouettes).

#include <imgui.h>

#include <glm/vec2.hpp>

#include "ui/picture/screen.h"
#include "ui/picture/tool.h"
#include "ui/widgets/area.h"

namespace glint {

struct MagnifierState {
    // 1, 2, 4 ... 64: window pixels a pixel, times the scale of the type, rounded up.
    int zoom = 1;
    glm::dvec2 centre{0.5};  // what lies in the middle, as a share of the picture's size
};
inline constexpr int max_zoom = 64, usual_zoom = 32;

/// Enlarges the picture's place in the window about the middle of `area`, and keeps `area` covered.
void magnify(PictureView& view, const Rect& area, const MagnifierState& magnifier);

/// Another zoom, the pixel at `share` staying where it is in the window.
void zoom_about(MagnifierState& magnifier, int zoom, glm::dvec2 share);

extern const Tool magnifier_tool;

/// Draws squares, their numbers, edges between faces, and the scan line and polygon of the picked pixel;
/// nothing before a pixel is large enough.
void draw_big_pixels(ImDrawList& list, UiState& state, const PictureView& view);

}  // namespace glint
