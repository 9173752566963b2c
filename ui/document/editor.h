#pragma once
// The document in hand: a scene, where it came from, whether it was saved, and how it came to be. No drawing.

#include <memory>
#include <optional>
#include <string>

#include "models/problem.h"
#include "models/scene_file/scene_file.h"
#include "ui/document/history.h"
#include "ui/document/scene_edit.h"

namespace glint {

struct Editor {
    SceneDocument document;  // `document.scene` is what panels edit
    Scene saved;             // as it was opened or saved last
    History history;
    Selection selection;
    std::unique_ptr<Editor> before;  // what was in hand, until this document has been drawn; then null

    [[nodiscard]] Scene& scene() { return document.scene; }
    [[nodiscard]] const Scene& scene() const { return document.scene; }
    [[nodiscard]] bool unsaved() const { return document.scene != saved; }
    /// File name for titles; "New scene" when there is none.
    [[nodiscard]] std::string title() const;
    /// True when saving needs no question: the document is a scene file already.
    [[nodiscard]] bool has_scene_file() const;
};

/// Puts a document in hand, with a fresh history; `before` keeps what was.
void take_document(Editor& editor, SceneDocument document);

/// Saves as a scene file. ".json" is added to a name without it.
[[nodiscard]] std::optional<Problem> save_file(Editor& editor, std::string path);

/// Whether the document's file is there and is not the one that was opened or saved last: saving would write
/// over what another program, or another window, has put there.
[[nodiscard]] bool changed_by_another(const Editor& editor);

/// Loads meshes that an edit left unloaded. On a problem the scene goes back to the newest step of the
/// history.
[[nodiscard]] std::optional<Problem> settle(Editor& editor);

/// One step back or forward; false when there is none.
bool undo(Editor& editor);
bool redo(Editor& editor);

/// A scene for a window that was given no file: a ball, a sun in the world and a bulb at the viewer's side.
[[nodiscard]] SceneDocument first_scene();

}  // namespace glint
