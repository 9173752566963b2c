#pragma once
// The scale of a display: from the window system's numbers to sizes of type and lengths.

#include <cstdint>
#include <glm/vec2.hpp>

namespace glint {

/// A window's size as reported by the window system. During a resize two queries may return different sizes.
struct WindowExtent {
    glm::ivec2 size{0}, size_after{0};  // size in the window's units, queried before and after `dots`
    glm::ivec2 dots{0};                 // size of the framebuffer, pixels
    float content_scale = 1;            // 1 on a display with 96 dots per inch
};

struct DisplayScale {
    float design = 1;         // the window's units per logical pixel
    float dots_per_unit = 1;  // pixels of the framebuffer per unit of the window
    bool operator==(const DisplayScale&) const = default;
};

/// Returns the scale that fits `extent`; `before` is the current one. Dots per logical pixel stay within 0.75
/// and 4, dots per unit within 0.5 and 4. Dots per unit do not change during a resize, if the window has
/// no area, or if the ratio differs only by rounding to whole dots: fonts are rebuilt only for a real change.
[[nodiscard]] DisplayScale display_scale(const WindowExtent& extent, const DisplayScale& before);

}  // namespace glint
