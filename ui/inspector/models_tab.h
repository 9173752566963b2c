#pragma once
// The same pixel under flat, facet, Gouraud and Phong shading, side by side, and how each comes by its
// colour.

#include <array>

#include "renderer/inspect/explain/explanation.h"

namespace glint {

struct UiState;
struct PictureView;

/// Pointing at a model shows the whole picture under it, a click takes it.
void models_tab(UiState& state, const PictureView& view);

/// The pixel under each mode of ShadingMode, in its order, whatever the scene's own mode is.
/// Precondition: the picture is of the edited scene, or of one with other lights, materials or shading.
[[nodiscard]] std::array<Explanation, 4> under_each_mode(const UiState& state, const Explanation& why);

}  // namespace glint
