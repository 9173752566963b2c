#pragma once
// Colours of the window. Each symbol has the same colour everywhere: in the equation, on handles, in plots.
// The symbols' colours are those of Okabe and Ito (2008), which remain distinct for colour-blind readers; if
// one is too dark or too light for the background, only its lightness is shifted. A letter always accompanies
// the colour.

#include <imgui.h>

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>

#include "models/scene/scene.h"

namespace glint {

/// Construction: intermediate vectors and quantities.
enum class Symbol { N, L, V, R, H, Ambient, Diffuse, Specular, Emission, Construction };
inline constexpr int symbol_count = 10;
/// Returns the letter that accompanies the colour: n, l, v, r, h, a, d, s or e; f denotes the constructed
/// quantities.
[[nodiscard]] constexpr const char* letter_of(Symbol symbol) {
    constexpr const char* letters[symbol_count] = {"n", "l", "v", "r", "h", "a", "d", "s", "e", "f"};
    return letters[static_cast<int>(symbol)];
}

struct Theme {
    bool dark = true;
    ImVec4 window, panel, field, field_hovered, field_active, line;  // from the back to the front
    ImVec4 text, dim_text, disabled_text;
    ImVec4 accent, accent_text;  // the selected item, and text on it
    ImVec4 warning, error;
    ImVec4 surround;  // around the picture: a neutral mid-grey, so that shades are judged correctly
    ImVec4 symbols[symbol_count];

    [[nodiscard]] const ImVec4& operator[](Symbol symbol) const { return symbols[static_cast<int>(symbol)]; }
};

[[nodiscard]] const Theme& dark_theme();
[[nodiscard]] const Theme& light_theme();
/// Returns a theme with stronger contrast, for a projector in a lit room: text, signs and symbols have a
/// contrast of at least 7:1 on every background they are drawn on.
[[nodiscard]] const Theme& projector_theme(bool dark);

/// Returns the background of a selected item while it is hovered or, if `pressed`, held down. It is shifted
/// away from accent_text, so that the text on it stays legible.
[[nodiscard]] ImVec4 accent_pointed_at(const Theme& theme, bool pressed);

/// Returns the theme applied last.
[[nodiscard]] const Theme& theme();

/// Sets ImGui's style: colours of `chosen`, sizes times `scale` (1 on a display of 96 dots per inch).
void apply_theme(const Theme& chosen, float scale);

/// Converts a design length to ImGui's units: `length` times the scale applied last, or `length` itself
/// without a context.
[[nodiscard]] float px(float length);

/// Returns the contrast of two opaque colours, 1 to 21. Source: WCAG 2.1, "contrast ratio".
[[nodiscard]] double contrast(const ImVec4& a, const ImVec4& b);

[[nodiscard]] ImU32 to_u32(const ImVec4& colour, float opacity = 1);

// Type: one family in a few sizes, and figures of equal width, so that numbers do not jitter during a drag.
// The fonts are found at run time among the system's fonts; if there are none, ImGui's own is used.

struct Fonts {
    ImFont* body = nullptr;
    ImFont* small = nullptr;
    ImFont* title = nullptr;
    ImFont* figures = nullptr;  // monospaced
    ImFont* reading = nullptr;  // for long texts
    ImFont* heading = nullptr;  // bold, for headings in long texts
};

/// Paths of the fonts to use; empty if none was found.
struct FontFiles {
    std::string text, bold, figures;
};
[[nodiscard]] FontFiles find_fonts();

/// Fills the atlas of the current ImGui context. `scale`: dots per logical pixel; `dots_per_unit`: dots per
/// ImGui unit (2 on a display that counts in points). Call this before the first frame, or between frames to
/// change the scale.
void load_fonts(const FontFiles& files, float scale, float dots_per_unit);

/// Returns the fonts loaded last.
[[nodiscard]] const Fonts& fonts();

/// Returns the height of text in the small font on the screen, including the projector's scale.
[[nodiscard]] float small_text_height();

// The scale of a display, derived from the window system's numbers; sizes of type and lengths depend on it.

/// A window's size as reported by the window system. During a resize, two queries may return different sizes.
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

/// Returns the scale that fits `extent`; `before` is the current one. Dots per logical pixel stay between
/// 0.75 and 4, dots per unit between 0.5 and 4. Dots per unit do not change during a resize, if the window
/// has no area, or if the ratio differs only by rounding to whole dots: fonts are rebuilt only for a real
/// change.
[[nodiscard]] DisplayScale display_scale(const WindowExtent& extent, const DisplayScale& before);

// Icons are drawn, so no icon font is needed, and a light's icon can have the light's own colour.

enum class Icon {
    Bulb,
    Sun,
    Spot,
    Area,
    Camera,
    Object,
    Shading,
    Display,
    Eye,
    EyeOff,
    Plus,
    Undo,
    Redo,
    Close,
    More,
    Folder,
    File,
    Up
};

/// Draws the icon in the square of side `size` centred at `centre`, in ImGui's units.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);

[[nodiscard]] Icon icon_of(LightKind kind);

/// Returns the light's colour at full brightness, for icons and handles; grey for a black light.
[[nodiscard]] ImVec4 colour_of(const Light& light);

/// Returns a light's colour, darkened until it is visible on the theme's panels, for lists.
[[nodiscard]] ImVec4 legible(ImVec4 colour);

/// Draws a square button with an icon, as high as a line of widgets. `on` draws it as chosen.
[[nodiscard]] bool icon_button(const char* id, Icon icon, bool on = false);

}  // namespace glint
