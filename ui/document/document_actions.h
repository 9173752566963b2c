#pragma once
// Opening, beginning anew, saving, quitting, and the question that comes first.

#include <string>

#include "ui/ui.h"

namespace glint {

/// Opens a file or begins anew, asking first when changes are not saved.
void begin_pending(UiState& state, Pending pending);
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

}  // namespace glint
