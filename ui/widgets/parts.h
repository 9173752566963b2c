#pragma once
// Parts of panels and of the picture's overlays, in addition to the fields in widgets.h: coloured text,
// buttons that show a choice, and marks, lines and badges that are legible on any picture.

#include <imgui.h>

#include <functional>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/scene/scene.h"
#include "ui/widgets/area.h"
#include "ui/widgets/theme.h"

namespace glint {

// Text of a panel.

void coloured(const ImVec4& colour, const std::string& text);
void coloured(Symbol symbol, const std::string& text);
/// Whether the character would end, break or widen a line of text. In names, such a character is drawn as a
/// blank.
[[nodiscard]] constexpr bool breaks_line(char c) { return c == '\n' || c == '\r' || c == '\t' || c == '\0'; }
/// Draws one line in the current font from `low`, cut off with dots if it would extend beyond `right`.
void cut_text(ImDrawList& list, ImVec2 low, float right, std::string_view text);
/// Draws the light's icon at ImGui's cursor, which does not move.
void light_icon(const Light& light);
/// Draws each word in its symbol's colour, all on one line.
void legend(std::initializer_list<std::pair<Symbol, std::string>> words);
void warning_text(const std::string& text);
void wrapped_dim(const std::string& text);
void small_dim(const std::string& text);
/// Draws a heading that can hide the controls below it; true if they are to be drawn. A click toggles it for
/// as long as the window is open. `open_at_first`: its state before the first click. `opens`: shows the
/// controls now.
[[nodiscard]] bool fold(const char* title, bool open_at_first, bool opens = false);

// Choices.

/// Draws a button, with the accent's background if `chosen`. It is `width` wide, or as wide as its label if
/// `width` is 0.
bool chosen_button(const char* label, bool chosen, float width = 0);
/// Returns the padding that makes a control with small text 24 high, as WCAG 2.2 (2.5.8) requires.
[[nodiscard]] ImVec2 small_padding();
/// Draw buttons with that padding.
bool small_button(const char* label);
bool small_chosen_button(const char* label, bool chosen);
/// Draws a drop-down of the lights' names, as wide as ImGui's next item. Clamps `light` to the range of
/// `lights`, which must not be empty. False while its list is open.
bool light_combo(const char* id, int& light, const std::vector<Light>& lights);
/// Draws controls with `draw` on the current line if `width` is free there, else behind a "»" button.
void overflow(const char* id, float width, const std::function<void()>& draw);
/// Continues on the line of the item drawn last if `width` still fits to the left of `right`.
void same_line_if_fits(float width, float gap, float right);

/// True while the mouse hovers over the item drawn last and nothing is being dragged. A panel may then
/// preview a scene other than the edited one.
[[nodiscard]] bool is_pointed_at();
/// The same test for a rectangle in the current window.
[[nodiscard]] bool is_pointed_at(const Rect& area);

// Over the picture. Widths and radii are in logical pixels, positions in the window's units.

/// Extra width of a dark line around a bright one.
inline constexpr float rim_width = 1.8f;
/// Returns the dark colour around bright lines and marks.
[[nodiscard]] ImU32 rim_colour(float opacity = 1);
/// Draws a bright line on a wider dark one.
void cased_line(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 colour, float width = 1.2f, float opacity = 1);
void cased_circle(ImDrawList& list, ImVec2 middle, float radius, ImU32 colour, float width);
void cased_outline(ImDrawList& list, const std::vector<ImVec2>& corners, ImU32 colour, float width,
                   bool closed);
/// Draws a disc with a dark rim.
void rimmed_disc(ImDrawList& list, ImVec2 middle, float radius, ImU32 colour, float opacity = 1);
/// Draws a triangle with its tip at `tip` that points along the unit vector `way`.
void arrow_head(ImDrawList& list, ImVec2 tip, ImVec2 way, float length, float half_width, ImU32 colour);
/// Draws text in the current font with a dark rim, centred at `middle`.
void rimmed_text(ImDrawList& list, ImVec2 middle, const ImVec4& colour, const std::string& text);

/// Draws the background for text over the picture.
void badge_ground(ImDrawList& list, const Rect& area, bool lit = false);
/// Draws text in the current font on such a background. `at`: its upper left corner, or the point at `pivot`
/// (fractions of its size). Returns its rectangle.
Rect badge(ImDrawList& list, ImVec2 at, const std::string& text, ImVec2 pivot = {0, 0});

}  // namespace glint
