#pragma once
// Shading that is no photograph: cool-to-warm tones, and strokes along silhouettes and creases.

#include "models/scene/scene.h"

namespace glint {

/// Edits `npr`; says whether it did. Numbers without effect are dimmed.
bool npr_panel(Npr& npr);

}  // namespace glint
