#pragma once
// An explanation for people: the lighting equation line by line, each with its numbers and what they come to.

#include <string>

#include "renderer/inspect/explain/explanation.h"

namespace glint {

/// UTF-8, lines of at most 110 columns unless names are long, ends with a newline.
/// `scene` is the one that was explained.
[[nodiscard]] std::string explain_text(const Explanation& explanation, const Scene& scene);

}  // namespace glint
