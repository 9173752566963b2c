#pragma once
// The reasons why the picture on the screen differs from the edited scene's own, correct picture: one list
// for the badge on the picture and for the message about a saved file.

#include <string>
#include <vector>

#include "ui/shell/notifications.h"
#include "ui/widgets/area.h"
#include "ui/widgets/shortcut.h"

namespace glint {

struct UiState;

struct PictureNote {
    enum class Kind {
        Preview,     // shown while the mouse hovers over something
        OtherScene,  // shown in place of the edited scene
        InScene,     // a setting of the scene itself, which is also in its file
        View         // applied to the picture, never saved
    };
    Kind kind = Kind::View;
    std::string name;
    void (*end)(UiState&) = nullptr;  // null: ends when another note does, or when the mouse moves on
    CommandId key = CommandId::None;  // the command that also ends it
    const char* remark = "";          // follows the name, only on the picture
};

/// Returns the notes of the shown picture, in the order of the badge; features add theirs (Feature::note).
[[nodiscard]] std::vector<PictureNote> picture_notes(const UiState& state);

/// Draws the badge in the upper left corner of `picture`, the picture's visible part: a line for each note,
/// with a button that ends the state described by the note.
void picture_badge(UiState& state, const Rect& picture);

/// The names of notes, joined by commas: those that apply to the file, and those that apply only in the
/// window.
struct FileNotes {
    std::string in_file, left_out;
};
/// Returns the notes for a file of the shown scene, or of the edited scene.
[[nodiscard]] FileNotes notes_of_shown(const UiState& state);
[[nodiscard]] FileNotes notes_of_edited(const UiState& state);

/// Returns "WHAT: Off: specular. Not in the file: Comparison", as a warning if something is left out.
[[nodiscard]] Notification file_message(const std::string& what, const FileNotes& notes);
/// Returns that text as it is before the file is written: "With: Off: specular. Not in the file: Comparison";
/// empty without notes.
[[nodiscard]] std::string file_warning(const FileNotes& notes);

}  // namespace glint
