#pragma once
// Where the picture lies in the window, and the camera that drew it.

#include <imgui.h>

#include "ui/picture/handles/light_place.h"
#include "ui/picture/screen.h"

namespace glint {

/// Where the picture lies in the window: ImGui's units from pixels of the picture.
struct PictureView {
    ImVec2 origin;
    float units_per_pixel = 1;
    ScreenMap map;
    Dome dome;
    Bounds bounds;  // of the scene, world

    [[nodiscard]] ImVec2 to_window(glm::dvec2 pixel) const {
        return {origin.x + float(pixel.x) * units_per_pixel, origin.y + float(pixel.y) * units_per_pixel};
    }
    [[nodiscard]] glm::dvec2 to_pixel(ImVec2 at) const {
        return {(at.x - origin.x) / units_per_pixel, (at.y - origin.y) / units_per_pixel};
    }
};

}  // namespace glint
