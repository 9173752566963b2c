#pragma once
// An explanation as JSON, as LaTeX and as text.

#include <string>

#include "models/json/json.h"
#include "models/scene/scene.h"
#include "renderer/explain/explanation.h"

namespace glint {

// An explanation as JSON; docs/explain.md says what each field is.

/// All of an explanation; as text it ends with a newline.
[[nodiscard]] Json explanation_json(const Explanation& explanation);
[[nodiscard]] std::string explain_json(const Explanation& explanation);

// An explanation as LaTeX: the lighting equation of one pixel with its numbers, ready for a slide or a paper.

/// Text for a document that loads amsmath; ends with a newline. An `align*` environment a lit point: one row
/// a term, red, green and blue as a column vector. Names from the scene are escaped. Precondition: the
/// explanation is of a pixel of this scene.
[[nodiscard]] std::string explain_latex(const Explanation& explanation, const Scene& scene);

// An explanation for people: the lighting equation line by line, each with its numbers and what they come to.

/// UTF-8, lines of at most 110 columns unless names are long, ends with a newline.
/// `scene` is the one that was explained.
[[nodiscard]] std::string explain_text(const Explanation& explanation, const Scene& scene);

}  // namespace glint
