#pragma once
// What matters here: every number of the scene, sorted by how much the picked pixel moves with it.

namespace glint {

struct UiState;
struct PictureView;

void sensitivity_tab(UiState& state, const PictureView& view);

}  // namespace glint
