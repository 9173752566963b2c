#pragma once
// The dialogs that hold up the window until they are answered, and the one rule for all of them: one at a
// time, begun after every other window of the frame.
//
// ImGui ends the program if a window appears, outside of a modal, after that modal has begun for the first
// time (imgui.cpp, FindBlockingModal). Two keys in one slow frame are enough to open both. So dialogs()
// stands last in a frame, and whoever asks for a dialog only says so in UiState.

#include <imgui.h>

#include "ui/feature.h"
#include "ui/ui.h"

namespace glint {

// The core's own dialogs. Of several that are requested, these come first, in this order, then features'.
extern const Dialog unsaved_dialog, changed_dialog, files_dialog;

/// The dialog that is on the screen, or will be at the end of this frame; null: none.
[[nodiscard]] const Dialog* open_dialog(const UiState& state);

/// Answers it as Escape does: nothing happens.
void leave_modal(UiState& state);

/// Closes the dialogs about the present scene before another scene replaces it: an answer would be meant for
/// the present one. Adds a notification that says so.
void leave_dialogs_of_scene(UiState& state);

/// Takes a dialog that nobody asks for any more off ImGui's list, before any window of a frame: a modal that
/// is no longer drawn would hold up every window that appears.
void close_left_modal(const UiState& state);

/// Opens the dialog `id` if it is not open yet and begins it; true: draw it, then ImGui::EndPopup().
/// `open`: where its cross is noted; null: it has none.
[[nodiscard]] bool begin_modal(const char* id, bool* open, ImGuiWindowFlags flags);

/// Whether a pressed Enter answers the dialog that was begun: not in the frame in which it appears, whose
/// Enter is the one that asked for it, in the palette.
[[nodiscard]] bool enter_answers(bool enter);

/// Begins a dialog as large as what is in it, in the middle of the window.
[[nodiscard]] bool begin_question(const char* id);

// The dialogs: the questions before work is lost, the file browser, the export.

/// Draws the one that is asked for, and does what it is answered. Last in a frame: ui/shell/modal.h.
void dialogs(UiState& state, const UiInput& input);

/// Files that were dropped on the window: the first is opened, or compared where it is a picture without a
/// scene.
void take_dropped(UiState& state, const std::vector<std::string>& paths);

}  // namespace glint
