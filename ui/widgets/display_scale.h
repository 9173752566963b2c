#pragma once
// How large things are on a display: from what the window system says of a window to sizes of type and
// lengths.

#include <cstdint>
#include <glm/vec2.hpp>

namespace glint {

/// What the window system says of a window. While it is being resized the answers to two questions may be of
/// two sizes.
struct WindowExtent {
    glm::ivec2 size{0}, size_after{0};  // in the window's units, asked before and after `dots`
    glm::ivec2 dots{0};                 // of the framebuffer, pixels
    float content_scale = 1;            // 1 on a display of 96 dots per inch
};

struct DisplayScale {
    float design = 1;         // the window's units per logical pixel
    float dots_per_unit = 1;  // pixels of the framebuffer per unit of the window
    bool operator==(const DisplayScale&) const = default;
};

/// Returns the scale that fits `extent`, `before` being the one in use. Dots per logical pixel stay within
/// 0.75 and 4, dots per unit within 0.5 and 4. Dots per unit stay as they are while a window is resized, if
/// it has no area, or if the ratio differs only by rounding to whole dots: fonts are rebuilt only for a true
/// change.
[[nodiscard]] DisplayScale display_scale(const WindowExtent& extent, const DisplayScale& before);

}  // namespace glint
