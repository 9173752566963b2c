#pragma once
// An explanation as LaTeX: the lighting equation of one pixel with its numbers, ready for a slide or a paper.

#include <string>

#include "models/scene/scene.h"
#include "renderer/inspect/explain/explanation.h"

namespace glint {

/// Text for a document that loads amsmath; ends with a newline. An `align*` environment a lit point: one row
/// a term, red, green and blue as a column vector. Names from the scene are escaped. Precondition: the
/// explanation is of a pixel of this scene.
[[nodiscard]] std::string explain_latex(const Explanation& explanation, const Scene& scene);

}  // namespace glint
