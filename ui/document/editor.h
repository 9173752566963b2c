#pragma once
// The document in hand: a scene, where it came from, whether it was saved, and how it came to be. No drawing.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/problem.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"
#include "ui/document/follow_items.h"
#include "ui/document/scene_edit.h"

namespace glint {

// Undo and redo: a list of scenes. A step costs the memory of its plain data and of those meshes that only it
// keeps, because the present scene has lost or changed them.

class History {
  public:
    /// Forgets all steps and begins at `scene`.
    void reset(const Scene& scene);

    /// Adds a step from the present scene to `scene`, named by what changed, and drops undone steps. A scene
    /// of the same description adds nothing. True if the present scene changed.
    bool commit(const Scene& scene);
    /// Sets the present step's view without adding a step. What is undone later is seen from there too,
    /// unless the step that is taken back edited the camera.
    void look(const Camera& camera) { steps_[at_].scene.camera = camera; }

    [[nodiscard]] const Scene& present() const { return steps_[at_].scene; }
    /// Returns the camera that the file or the last edit set, whatever view was taken since.
    [[nodiscard]] const Camera& edited_camera() const { return steps_[at_].edited_camera; }
    [[nodiscard]] bool can_undo() const { return at_ > 0; }
    [[nodiscard]] bool can_redo() const { return at_ + 1 < steps_.size(); }
    /// Names of the step that undo() takes back and of the one that redo() does again; empty when there is
    /// none.
    [[nodiscard]] std::string undo_name() const { return can_undo() ? steps_[at_].name : std::string(); }
    [[nodiscard]] std::string redo_name() const { return can_redo() ? steps_[at_ + 1].name : std::string(); }

    /// Preconditions: can_undo() and can_redo().
    const Scene& undo();
    const Scene& redo();

  private:
    struct Step {
        std::string name;  // of the change that led here
        Scene scene;
        Camera edited_camera;
        bool edits_camera = false;
    };
    void forget_oldest();
    [[nodiscard]] bool is_too_large() const;
    /// Adds up the meshes of all steps that the present scene does not have, each once.
    [[nodiscard]] std::uint64_t bytes_of_lost_meshes() const;

    std::vector<Step> steps_ = std::vector<Step>(1);
    std::size_t at_ = 0;
};

/// What changed between two scenes, as the name of a step: "Move Bulb", "Material of Teapot", "Add Lamp".
/// Empty when their descriptions are equal.
[[nodiscard]] std::string step_name(const Scene& before, const Scene& after);

/// The views that were left: one can go back to them and forward again, apart from undo.
class ViewHistory {
  public:
    /// The view moves away from `camera`: one can come back to it.
    void leave(const Camera& camera);
    [[nodiscard]] bool can_go_back() const { return !before_.empty(); }
    [[nodiscard]] bool can_go_forward() const { return !after_.empty(); }
    /// The view before or after `now`. Preconditions: can_go_back() and can_go_forward().
    [[nodiscard]] Camera back(const Camera& now);
    [[nodiscard]] Camera forward(const Camera& now);

  private:
    std::vector<Camera> before_, after_;  // the nearest last
};

/// What a document without a file of its own was made from: a lesson.
struct DocumentSource {
    std::string title, path;
};

struct Editor {
    SceneDocument document;      // `document.scene` is what panels edit
    Scene saved;                 // as it was opened or saved last
    Camera saved_edited_camera;  // History::edited_camera() at that time
    History history;
    ViewHistory views;
    bool edits_camera = false;  // the camera's numbers are being edited: that is an edit, not a look
    DocumentSource source;
    Selection selection;
    std::optional<Scene> valid;             // the scene as it last was one that a file can hold
    std::optional<FollowedItems> followed;  // nothing until the scene was drawn first
    std::unique_ptr<Editor> before;         // what was in hand, until this document has been drawn; then null

    [[nodiscard]] Scene& scene() { return document.scene; }
    [[nodiscard]] const Scene& scene() const { return document.scene; }
    /// Edits that are in no file. Where one looks from is not an edit.
    [[nodiscard]] bool unsaved() const {
        return !same_but_camera(document.scene, saved) || history.edited_camera() != saved_edited_camera;
    }
    /// file_title() its path.
    [[nodiscard]] std::string title() const;
    /// True when saving needs no question: the document is a scene file already.
    [[nodiscard]] bool has_scene_file() const;
};

/// The name of a file for titles and questions; "New scene" when there is none. On one line and at most 80
/// characters long: a path that anyone may have written does not push away what stands below it.
[[nodiscard]] std::string file_title(const std::string& path);

/// Puts a document in hand, with a fresh history; `before` keeps what was.
void take_document(Editor& editor, SceneDocument document);

/// Saves `scene`, the edited one or what of it can be opened again (as_made), as a scene file. ".json" is
/// added to a name without it.
[[nodiscard]] std::optional<Problem> save_file(Editor& editor, std::string path, const Scene& scene);

/// Whether the document's file is there and is not the one that was opened or saved last: saving would write
/// over what another program, or another window, has put there.
[[nodiscard]] bool changed_by_another(const Editor& editor);

/// Takes back what makes the scene one that no file could hold, and returns what it was: a number beyond its
/// field's range, a condition that is broken. Whatever edits the scene, it can be saved, copied and
/// recovered.
[[nodiscard]] std::optional<Problem> take_back_invalid(Editor& editor);

/// The scene is again that of the history's newest step.
void take_back_edits(Editor& editor);

/// Loads meshes that an edit left unloaded. On a problem the scene returns to the history's newest step.
[[nodiscard]] std::optional<Problem> settle(Editor& editor);

/// Records what was done since, as an edit or a change of view. `join`: it continues the last such change.
/// Returns true if it was an edit.
bool remember_step(Editor& editor, bool join);

/// Goes one step back or forward; false if there is none. The view stays, unless the step edited the camera.
bool undo(Editor& editor);
bool redo(Editor& editor);

/// A scene for a window that was given no file: a ball, a sun in the world and a bulb at the viewer's side.
[[nodiscard]] SceneDocument first_scene();

}  // namespace glint
