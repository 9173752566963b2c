#pragma once
// The equation tab shows the lighting equation at the picked pixel, with its numbers. Everything comes from
// the renderer's own explanation, so the terms sum to the pixel.

#include <span>
#include <string>

#include "models/scene/scene.h"
#include "renderer/explain/equation_text.h"
#include "renderer/explain/explain.h"
#include "ui/features/inspector/equation/text_line.h"

namespace glint {

struct UiState;
struct PictureView;

void equation_tab(UiState& state, const PictureView& view);

/// Draws I = emission + ambient + diffuse + specular: a row per term, a column per channel. A click on a
/// channel writes out its products. Hovering over a term previews it alone in the picture.
void sum_table(UiState& state, const Explanation& explanation);

/// Shows how the sum is converted for display: stroke, exposure, transfer, clipping.
void display_lines(const UiState& state, const Explanation& explanation);

/// Draws one light's part of the equation at the picked point: name, angles, the common factor of all terms,
/// and the three terms as products of the chosen channel. `which`: index into point.lights. The scene's
/// numbers can be dragged. Hovering over the name shows the light alone; over a term, that term of this light
/// alone; over a letter, its arrow. `added`: what the light adds to the pixel.
void light_card(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                std::size_t which, glm::vec3 added);

/// "“Teapot” is between this light and the point, but …" under the local model; empty if nothing is in
/// between, or if the light is behind the surface anyway. `which`: index into the point's lights.
[[nodiscard]] std::string blocked_words(const UiState& state, const Explanation& explanation,
                                        std::size_t which);

/// Draws letter = factor × factor … = result, in one channel (0 red, 1 green, 2 blue), with as many digits as
/// the result needs. The scene's numbers can be dragged; the others can be copied.
void draw_line(const EquationLine& line, const HandledScene& scene, int channel);

enum class CopyAs { Text, Json, Latex };
struct CopyFormat {
    CopyAs as;
    const char* label;  // "JSON"
    const char* what;   // a sentence about it
};
[[nodiscard]] std::span<const CopyFormat> copy_formats();
/// Copies the explanation to the clipboard and reports it. Precondition: there is one.
void copy_explanation(const UiState& state, const CopyFormat& format);

/// The exact text that `glint explain --format …` prints for this pixel.
[[nodiscard]] std::string explained_as(CopyAs format, const Explanation& explanation, const Scene& scene);

// The context menu of a read-only number: copies the number, or the line that contains it.

/// Opens on a right click on the item drawn last. `number`: as displayed. An empty `line` is not offered.
/// `id` distinguishes numbers at the same position.
void copy_menu(int id, const std::string& number, const std::string& line);

}  // namespace glint
