#pragma once
// Colours of the window. One colour per symbol, everywhere: in the equation, on handles, in plots. The
// symbols' colours are those of Okabe and Ito (2008), which remain distinct for colour-blind readers; one
// that is too dark or too light for the background is shifted in lightness only. A letter always accompanies
// the colour.

#include <imgui.h>

namespace glint {

/// Construction: intermediate vectors and quantities.
enum class Symbol { N, L, V, R, H, Ambient, Diffuse, Specular, Emission, Construction };
inline constexpr int symbol_count = 10;
/// The letter that accompanies the colour: n, l, v, r, h, a, d, s, e; f is the first of the constructed
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
    ImVec4 surround;  // around the picture: neutral, of medium lightness, so that shades appear as they are
    ImVec4 symbols[symbol_count];

    [[nodiscard]] const ImVec4& operator[](Symbol symbol) const { return symbols[static_cast<int>(symbol)]; }
};

[[nodiscard]] const Theme& dark_theme();
[[nodiscard]] const Theme& light_theme();
/// Stronger contrast, for a projector in a lit room: text, signs and symbols have at least 7:1 on every
/// background they are drawn on.
[[nodiscard]] const Theme& projector_theme(bool dark);

/// The background of a selected item while hovered (`pressed`: and pressed): shifted away from accent_text,
/// so that the text on it stays legible.
[[nodiscard]] ImVec4 accent_pointed_at(const Theme& theme, bool pressed);

/// The theme applied last.
[[nodiscard]] const Theme& theme();

/// Sets ImGui's style: colours of `chosen`, sizes times `scale` (1 on a display of 96 dots per inch).
void apply_theme(const Theme& chosen, float scale);

/// A design length in ImGui's units: `length` times the scale applied last.
[[nodiscard]] float px(float length);

/// Contrast of two opaque colours, 1 to 21. Source: WCAG 2.1, "contrast ratio".
[[nodiscard]] double contrast(const ImVec4& a, const ImVec4& b);

[[nodiscard]] ImU32 to_u32(const ImVec4& colour, float opacity = 1);

}  // namespace glint
