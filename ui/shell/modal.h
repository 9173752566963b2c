#pragma once
// The dialogs that block the window until they are answered, and one rule for all of them: one at a time,
// begun after every other window of the frame.
//
// ImGui terminates the program if a window outside a modal appears after that modal has begun for the first
// time (imgui.cpp, FindBlockingModal). Two keys pressed in one slow frame are enough to open both. So
// dialogs() is called last in a frame, and other code requests a dialog by setting UiState.

#include <imgui.h>

#include "ui/feature.h"
#include "ui/ui.h"

namespace glint {

// The core's own dialogs. If several dialogs are requested, these come first, in this order, then those of
// features.
extern const Dialog unsaved_dialog, changed_dialog, files_dialog;

/// Returns the dialog that is on the screen now, or will be at the end of this frame; null: none.
[[nodiscard]] const Dialog* open_dialog(const UiState& state);

/// Cancels the dialog, as Escape does.
void leave_modal(UiState& state);

/// Closes the dialogs about the current scene before another scene replaces it, since an answer would be
/// about the current one. Reports each closed dialog in a notification.
void leave_dialogs_of_scene(UiState& state);

/// Removes a dialog that is no longer requested from ImGui's list, before any window of a frame: a modal that
/// is open but not drawn would block every window that appears.
void close_left_modal(const UiState& state);

/// Opens the dialog `id` if needed and begins it; true: draw it, then call ImGui::EndPopup(). `open`: set to
/// false by its close button; null: it has none.
[[nodiscard]] bool begin_modal(const char* id, bool* open, ImGuiWindowFlags flags);

/// Whether a pressed Enter answers the current dialog: not in the frame in which the dialog appears, because
/// that Enter opened it from the palette.
[[nodiscard]] bool enter_answers(bool enter);

/// Begins a dialog that fits its contents, at the centre of the window.
[[nodiscard]] bool begin_question(const char* id);

// The dialogs: questions before work is lost, the file browser, the export.

/// Draws the requested dialog and acts on its answer. Call this last in a frame; see the top of this file.
void dialogs(UiState& state, const UiInput& input);

/// Handles files dropped on the window: opens the first, or compares it if it is a picture without a scene.
void take_dropped(UiState& state, const std::vector<std::string>& paths);

}  // namespace glint
