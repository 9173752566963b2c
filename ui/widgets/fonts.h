#pragma once
// Type: one family in a few sizes, and figures of equal width so that numbers do not jitter during a drag.
// Found at run time among the system's fonts; ImGui's own if there is none.

#include <imgui.h>

#include <string>

namespace glint {

struct Fonts {
    ImFont* body = nullptr;
    ImFont* small = nullptr;
    ImFont* title = nullptr;
    ImFont* figures = nullptr;  // monospaced
    ImFont* reading = nullptr;  // for long texts
    ImFont* heading = nullptr;  // bold, for their headings
};

/// Paths of the fonts to use; empty if none was found.
struct FontFiles {
    std::string text, bold, figures;
};
[[nodiscard]] FontFiles find_fonts();

/// Fills the atlas of the current ImGui context. `scale`: dots per logical pixel; `dots_per_unit`: of ImGui
/// (2 on a display that counts in points). Call before the first frame, or between frames to change the
/// scale.
void load_fonts(const FontFiles& files, float scale, float dots_per_unit);

/// The fonts loaded last.
[[nodiscard]] const Fonts& fonts();

/// Height of text in the small font on the screen, including the projector's scale.
[[nodiscard]] float small_text_height();

}  // namespace glint
