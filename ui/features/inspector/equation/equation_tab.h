#pragma once
// The equation tab shows the lighting equation at the picked pixel, with its numbers. All is read from the
// renderer's own explanation, so that it sums to the pixel.

#include <span>
#include <string>

#include "models/scene/scene.h"
#include "renderer/explain/equation_line.h"
#include "renderer/explain/explanation.h"
#include "ui/features/inspector/equation/number_handle.h"

namespace glint {

struct UiState;
struct PictureView;

void equation_tab(UiState& state, const PictureView& view);

/// Draws I = emission + ambient + diffuse + specular: a row a term, a column a channel; a click on a channel
/// chooses whose products are written out. Pointing at a term shows it alone in the picture.
void sum_table(UiState& state, const Explanation& explanation);

/// Says what becomes of the sum on its way to the screen: stroke, exposure, transfer, clipping.
void display_lines(const UiState& state, const Explanation& explanation);

/// Draws one light's part of the equation at the picked point: name, angles, what all terms are multiplied
/// by, and the three terms as products of the chosen channel. `which`: of point.lights. Numbers of the scene
/// can be dragged; pointing at the name shows the light alone, at a term that term of this light alone, at a
/// letter its arrow.
void light_card(UiState& state, const Explanation& explanation, const ExplainedPoint& point,
                std::size_t which);

/// "“Teapot” stands in the way of this light, but …"; empty where the way is free, where the
/// light is behind the surface anyway, and while the mouse drags something in a scene so large that asking
/// would take time. `which`: index into `point.lights`.
[[nodiscard]] std::string blocked_words(UiState& state, const Explanation& explanation,
                                        const ExplainedPoint& point, std::size_t which);

/// letter = factor × factor … = result, in one channel (0 red, 1 green, 2 blue), with as many digits as the
/// result needs. Numbers of the scene can be dragged, the others copied. True when a number was edited.
bool draw_line(const EquationLine& line, const HandledScene& scene, int channel);

enum class CopyAs { Text, Json, Latex };
struct CopyFormat {
    CopyAs as;
    const char* label;  // "JSON"
    const char* what;   // a sentence about it
};
[[nodiscard]] std::span<const CopyFormat> copy_formats();
/// Puts the explanation into the clipboard and says so. Precondition: there is one.
void copy_explanation(const UiState& state, const CopyFormat& format);

/// The very text that `glint explain --format …` prints for this pixel.
[[nodiscard]] std::string explained_as(CopyAs format, const Explanation& explanation, const Scene& scene);

}  // namespace glint
