#pragma once
// The lighting equation at the picked pixel, with its numbers. Everything shown is read from the renderer's
// own explanation, so that it sums to the pixel.

#include <string>

#include "models/scene/scene.h"
#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;
struct PictureView;

void equation_tab(UiState& state, const PictureView& view);

// The lighting equation in letters, each in its symbol's colour.

/// One line, as wide as the equation is long.
void equation(Reflection reflection);

// I = emission + ambient + diffuse + specular in all three channels.

/// A row a term, a column a channel; a click on a channel chooses whose products are written out. Pointing at
/// a term shows it alone in the picture.
void sum_table(UiState& state, const Explanation& explanation);

/// What becomes of the sum on its way to the screen: stroke, exposure, transfer, clipping.
void display_lines(const UiState& state, const Explanation& explanation);

// One light's part of the equation at the picked point, its numbers where they stand.

struct TermLine;

/// Name, angles, what all terms are multiplied by, and the three terms as products of the chosen channel.
/// `which`: of point.lights. Numbers of the scene can be dragged; pointing at the name shows the light alone,
/// at a term that term of this light alone, at a letter its arrow.
void light_card(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                std::size_t which);

/// letter = factor × factor … = result. True when a number was edited.
bool draw_term_line(const TermLine& line);

// The explanation for other programs: what `glint explain` prints, on the clipboard.

enum class CopyAs { Text, Json, Latex };

/// The very text that `glint explain --format …` prints for this pixel.
[[nodiscard]] std::string explained_as(CopyAs format, const Explanation& explanation, const Scene& scene);

/// A button for each format.
void copy_buttons(const Explanation& explanation, const Scene& scene);

}  // namespace glint
