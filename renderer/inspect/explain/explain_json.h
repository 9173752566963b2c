#pragma once
// An explanation as JSON; docs/explain.md says what each field is.

#include <string>

#include "renderer/inspect/explain/explanation.h"

namespace glint {

/// All of an explanation, ends with a newline.
[[nodiscard]] std::string explain_json(const Explanation& explanation);

}  // namespace glint
