#pragma once
// The lighting equation at the picked pixel, with its numbers. Everything shown is read from the renderer's
// own explanation, so that it sums to the pixel.

namespace glint {

struct UiState;
struct PictureView;

void equation_tab(UiState& state, const PictureView& view);

}  // namespace glint
