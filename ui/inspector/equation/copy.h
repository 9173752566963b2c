#pragma once
// The explanation for other programs: what `glint explain` prints, on the clipboard.

#include <string>

#include "renderer/inspect/explain/explanation.h"

namespace glint {

enum class CopyAs { Text, Json, Latex };

/// The very text that `glint explain --format …` prints for this pixel.
[[nodiscard]] std::string explained_as(CopyAs format, const Explanation& why, const Scene& scene);

/// A button for each format.
void copy_buttons(const Explanation& why, const Scene& scene);

}  // namespace glint
