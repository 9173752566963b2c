#pragma once
// The window's side of animations: choose, play, write as PNG files or as a GIF.

#include "ui/ui.h"

namespace glint {

/// The panel, while it is open.
void animate_panel(UiState& state);

/// Once a frame: what plays is shown in the next one; what is being written goes on.
void poll_animation(UiState& state);

/// Writes all frames aside: NAME.png as NAME-0001.png, NAME-0002.png, …, each carrying its scene; NAME.gif as
/// one file. The picture's size is `size`, with `samples` a pixel.
void begin_frames(UiState& state, const std::string& path, PictureSize size, int samples);

}  // namespace glint
