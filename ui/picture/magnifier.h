#pragma once
// The magnifier enlarges the picture as it is, without drawing it again, until each pixel is a square with
// its number in it. Lecture: "Gouraud Shading" (scanlines), "Shading Artifacts" (silhouettes).

#include <imgui.h>

#include <glm/vec2.hpp>

#include "renderer/renderer.h"
#include "ui/picture/screen.h"
#include "ui/shell/layout.h"

namespace glint {

struct MagnifierState {
    int zoom = 1;            // 1, 2, 4 ... 64: window pixels a pixel
    glm::dvec2 centre{0.5};  // what lies in the middle, as a share of the picture's size
};
inline constexpr int most_zoom = 64, usual_zoom = 32;

/// Enlarges the picture's place in the window about the middle of `area`, and keeps `area` covered.
void magnify(PictureView& view, const Rect& area, const MagnifierState& magnifier);

/// Another zoom, the pixel at `share` staying where it is in the window.
void zoom_about(MagnifierState& magnifier, int zoom, glm::dvec2 share);

}  // namespace glint
