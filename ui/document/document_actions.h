#pragma once
// Opens, begins anew, saves and quits, with the question that comes first; and keeps the window going where
// memory does not suffice.

#include <exception>
#include <string>

#include "renderer/picture.h"
#include "ui/ui.h"

namespace glint {

/// Opens the file `path`, begins anew or quits, asking first when changes are not saved.
void begin_pending(UiState& state, Pending::What what, const std::string& path = {});
/// Goes on with what waited, after the answer or after saving.
void finish_pending(UiState& state);
/// Puts another document in hand. All that was about the scene before goes: gesture, probe, explanation, what
/// was about to be done to one of its lights or objects.
void take_scene(UiState& state, SceneDocument document);
/// A name to offer for a file: the document's own, with the ending that fits.
[[nodiscard]] std::string offered_name(const UiState& state, const char* ending);
/// Saves; asks for a name when there is none yet, and first when another program has changed the file. True
/// when it is saved now.
bool save(UiState& state);
/// Saves whatever is in the file. True when it is saved now.
bool save_over(UiState& state);
/// Opens the document's file again, giving up what is not saved.
void reload(UiState& state);

// Where memory does not suffice the scene that could be drawn last stays in hand, and the window goes on.

/// After an exception while the edited scene (or, if `previewed`, another one in its place) was drawn: says
/// so, puts the document or the scene that was drawn before back in hand, and draws that, smaller where
/// `full` is too much. Rethrows when nothing has been drawn yet, or even an empty scene cannot be.
void take_back(UiState& state, const std::exception& error, PictureSize full, bool previewed);

/// After an exception anywhere in a frame: says so, closes what ImGui has open, and puts away what is drawn
/// beside the picture. The next frame begins afresh.
void give_up_frame(UiState& state, const std::exception& error);

}  // namespace glint
