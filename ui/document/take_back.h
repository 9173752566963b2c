#pragma once
// What happens where memory does not suffice: the scene that could be drawn last stays in hand, and the
// window goes on.

#include <exception>

#include "renderer/picture.h"

namespace glint {

struct UiState;

/// After an exception while the edited scene (or, if `previewed`, another one in its place) was drawn: says
/// so, puts the document or the scene that was drawn before back in hand, and draws that, smaller where
/// `full` is too much. Rethrows when nothing has been drawn yet, or even an empty scene cannot be.
void take_back(UiState& state, const std::exception& error, PictureSize full, bool previewed);

/// After an exception anywhere in a frame: says so, closes what ImGui has open, and puts away what is drawn
/// beside the picture. The next frame begins afresh.
void give_up_frame(UiState& state, const std::exception& error);

/// The words for an exception that ends a piece of the window's work.
void say_what_failed(UiState& state, const std::exception& error);

}  // namespace glint
