#pragma once
// n, l, v and r or h drawn at the picked point in the picture, with their angles; the corners that a Gouraud
// pixel is mixed from; the facet's edges and normal.

#include <imgui.h>

namespace glint {

struct UiState;
struct PictureView;

/// Nothing while they are switched off or no object is picked. They are drawn over what stands before them.
void draw_point_vectors(ImDrawList& list, const UiState& state, const PictureView& view);

}  // namespace glint
