#pragma once
// The vectors of the equation at the picked point: in both frames, in the plane of incidence, and how r and
// the facet's normal come about.

namespace glint {

struct UiState;
struct PictureView;

void vectors_tab(UiState& state, const PictureView& view);

}  // namespace glint
