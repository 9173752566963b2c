#pragma once
// Opening, creating, saving and quitting, each after a question if work could be lost. Also keeps the window
// running after an exception.

#include <exception>
#include <filesystem>
#include <functional>
#include <string>

#include "renderer/picture.h"
#include "ui/ui.h"

namespace glint {

inline constexpr const char* only_first_of_several = "Several files were dropped: only the first is opened";

/// Whether the file, with symbolic links resolved, is in the folder of the scenes that come with the program.
/// They must not change, and user files do not belong there.
[[nodiscard]] bool is_among_shipped(const UiState& state, const std::string& path);

// The purposes of the file dialog.
extern const FilePurpose open_purpose, mesh_purpose, save_purpose;

/// Calls `then` now or, if there are unsaved changes, after the answer to "save changes?". Changes to an
/// example are kept in RecentlyChanged instead, until the window closes.
void ask_first(UiState& state, std::function<void(UiState&)> then);
/// Opens the file `path`, asking first if there are unsaved changes. `left_out`: the number of files dropped
/// with it that are not opened; it is reported when the file opens.
void ask_to_open(UiState& state, const std::string& path, std::size_t left_out = 0);
/// Continues the waiting action after the answer or after saving.
void finish_pending(UiState& state);
/// Whether `next` is a different scene, and not the open file again.
[[nodiscard]] bool is_another(const UiState& state, const SceneDocument& next);
/// Closes everything shown over or in place of the picture, because an unrelated scene replaces the current
/// one.
void put_away(UiState& state);
/// Makes `document` the open one. Drops everything that belongs to the previous scene: gesture, probe,
/// explanation, and pending actions on its lights or objects.
void take_scene(UiState& state, SceneDocument document);
/// Opens the dialog that chooses a mesh file for the object at that index, or for a new object if it is -1.
void ask_mesh(UiState& state, int object);
/// Returns the user's folder for pictures; empty, meaning the working directory, if there is none. Source:
/// xdg-user-dirs, user-dirs.dirs(5).
[[nodiscard]] std::filesystem::path pictures_folder();
/// Returns the suggested file name: the document's own, with the matching extension. If the document is not a
/// user file, the suggestion is in pictures_folder(), or in the working directory for a scene.
[[nodiscard]] std::string offered_name(const UiState& state, const char* ending);
/// Saves the document. Requests a name if there is none yet, and asks first if another program has changed
/// the file. True if the document is now saved.
bool save(UiState& state);
/// Saves and overwrites the file. True if the document is now saved.
bool save_over(UiState& state);
/// Saves to that file and reports the result. True if the document is now saved.
bool save_as(UiState& state, const std::string& path);
/// Reopens the document's file, discarding unsaved changes.
void reload(UiState& state);

/// After an exception in the renderer, restores the last drawn scene (unless a preview failed: `previewed`)
/// and draws it again. Rethrows if nothing has been drawn yet.
void draw_scene_before(UiState& state, bool previewed);

/// Handles an exception anywhere in a frame: reports it, ends ImGui's unfinished windows and stacks, and
/// closes the views drawn in addition to the picture. The next frame starts clean. Rethrows if there is no
/// picture.
void give_up_frame(UiState& state, const std::exception& error);

}  // namespace glint
