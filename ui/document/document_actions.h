#pragma once
// Opens, begins anew, saves and quits, asking first where work could be lost; and keeps the window going
// after an exception.

#include <exception>
#include <functional>
#include <string>

#include "renderer/picture.h"
#include "ui/ui.h"

namespace glint {

inline constexpr const char* only_first_of_several = "Several files were dropped: only the first is opened";

/// Whether a file of that path lies, links followed, in the folder of the scenes that come with the program:
/// they stay as they are, and nothing of the user's belongs there.
[[nodiscard]] bool is_among_shipped(const UiState& state, const std::string& path);

// The files that are opened and saved.
extern const FilePurpose open_purpose, mesh_purpose, save_purpose;

/// Does `then` now, or after the answer to "save changes?" where changes are not saved.
void ask_first(UiState& state, std::function<void(UiState&)> then);
/// Opens the file `path`, asking first. `left_out`: files that were dropped with that one, and are not
/// opened; that is said when it is.
void ask_to_open(UiState& state, const std::string& path, std::size_t left_out = 0);
/// Goes on with what waited, after the answer or after saving.
void finish_pending(UiState& state);
/// Whether `next` is another scene than the open one, not that file again.
[[nodiscard]] bool is_another(const UiState& state, const SceneDocument& next);
/// Ends whatever is shown in place of the picture or over it, for a scene that is about something else.
void put_away(UiState& state);
/// Makes `document` the open one. Everything about the scene before is dropped: gesture, probe, explanation,
/// and what was about to be done to one of its lights or objects.
void take_scene(UiState& state, SceneDocument document);
/// Asks for the mesh file of the object of that index; of a new one for -1.
void ask_mesh(UiState& state, int object);
/// A name to offer for a file: the document's own, with the ending that fits.
[[nodiscard]] std::string offered_name(const UiState& state, const char* ending);
/// Saves the document. Asks for a name if there is none yet, and asks first if another program has changed
/// the file. True if it is saved now.
bool save(UiState& state);
/// Saves whatever is in the file. True when it is saved now.
bool save_over(UiState& state);
/// Saves to that file and says what came of it. True when it is saved now.
bool save_as(UiState& state, const std::string& path);
/// Opens the document's file again, giving up what is not saved.
void reload(UiState& state);

/// Restores the scene that was drawn last (unless a preview failed: `previewed`) and draws it again, after
/// the renderer has thrown. Rethrows if nothing has been drawn yet.
void draw_scene_before(UiState& state, bool previewed);

/// Handles an exception anywhere in a frame: reports it, closes what ImGui has open, and closes the views
/// drawn in addition to the picture. The next frame begins afresh. Rethrows if there is no picture.
void give_up_frame(UiState& state, const std::exception& error);

}  // namespace glint
