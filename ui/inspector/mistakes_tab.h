#pragma once
// Mistakes that students really make, as switches: on, one sees how each is recognised; pointed at, one sees
// it for as long as the mouse rests there.

#include "models/scene/shading.h"

namespace glint {

struct UiState;
struct PictureView;

void mistakes_tab(UiState& state, const PictureView& view);

/// How many are on.
[[nodiscard]] int mistakes_on(const Mistakes& mistakes);

}  // namespace glint
