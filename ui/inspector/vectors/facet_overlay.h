#pragma once

#include <imgui.h>

namespace glint {

struct UiState;
struct PictureView;

/// The picked facet in the picture: its outline with the corners numbered in their order, two edges and its
/// normal.
void draw_facet(ImDrawList& list, const UiState& state, const PictureView& view);

}  // namespace glint
