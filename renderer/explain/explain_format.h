#pragma once
// Writes an explanation as JSON, LaTeX and text.

#include <string>

#include "models/json/json.h"
#include "models/scene/scene.h"
#include "renderer/explain/explanation.h"

namespace glint {

// JSON; docs/explain.md documents each field.

/// The entire explanation; as text it ends with a newline.
[[nodiscard]] Json explanation_json(const Explanation& explanation);
[[nodiscard]] std::string explain_json(const Explanation& explanation);

// LaTeX: the lighting equation of one pixel with its numbers, ready for a slide or a paper.

/// Output for a document that loads amsmath; ends with a newline. One `align*` environment per lit point, one
/// row per term; red, green and blue form a column vector. Escapes names from the scene. Precondition: the
/// explanation is of a pixel of this scene.
[[nodiscard]] std::string explain_latex(const Explanation& explanation, const Scene& scene);

// Text: the lighting equation line by line, each with its numbers and their result.

/// UTF-8, lines of at most 110 columns unless names are long, ends with a newline. `scene` is the explained
/// scene.
[[nodiscard]] std::string explain_text(const Explanation& explanation, const Scene& scene);

}  // namespace glint
