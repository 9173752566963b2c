#pragma once
// The open document: a scene, its file, its saved state and its history. Does not draw.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/problem.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"
#include "ui/document/scene_edit.h"

namespace glint {

// Undo and redo: a list of scenes. A step takes memory for its plain data, and for the meshes that the
// current scene no longer has.

class History {
  public:
    /// Drops all steps and starts at `scene`.
    void reset(const Scene& scene);

    /// Adds a step from the current scene to `scene`, named after the change, and drops undone steps. A scene
    /// with the same description adds no step. True if the current scene changed.
    bool commit(const Scene& scene);
    /// Sets the current step's camera without adding a step. Later undos keep this view, unless the undone
    /// step edited the camera.
    void look(const Camera& camera) { steps_[at_].scene.camera = camera; }

    [[nodiscard]] const Scene& present() const { return steps_[at_].scene; }
    /// Returns the camera set by the file or the last edit, regardless of later view changes.
    [[nodiscard]] const Camera& edited_camera() const { return steps_[at_].edited_camera; }
    [[nodiscard]] bool can_undo() const { return at_ > 0; }
    [[nodiscard]] bool can_redo() const { return at_ + 1 < steps_.size(); }
    /// The names of the step that undo() reverts and the step that redo() restores; empty if there is none.
    [[nodiscard]] std::string undo_name() const { return can_undo() ? steps_[at_].name : std::string(); }
    [[nodiscard]] std::string redo_name() const { return can_redo() ? steps_[at_ + 1].name : std::string(); }

    /// The steps, oldest first, and the index of the current one. The oldest has no name.
    [[nodiscard]] std::size_t size() const { return steps_.size(); }
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] const std::string& name_of(std::size_t step) const { return steps_[step].name; }

    /// Preconditions: can_undo() and can_redo(), respectively.
    const Scene& undo();
    const Scene& redo();

  private:
    struct Step {
        std::string name;  // name of the change that produced this scene
        Scene scene;
        Camera edited_camera;
        bool edits_camera = false;
    };
    void forget_oldest();
    [[nodiscard]] bool is_too_large() const;
    /// Returns the total size of all meshes in the steps that the current scene does not use, each counted
    /// once.
    [[nodiscard]] std::uint64_t bytes_of_lost_meshes() const;

    std::vector<Step> steps_ = std::vector<Step>(1);
    std::size_t at_ = 0;
};

/// Returns the name of a step from one scene to the other: "Move Bulb", "Material of Teapot", "Add Lamp".
/// Empty if their descriptions are equal.
[[nodiscard]] std::string step_name(const Scene& before, const Scene& after);

/// Earlier views. Going back and forward through them is independent of undo.
class ViewHistory {
  public:
    /// Records `camera` before the view changes.
    void leave(const Camera& camera);
    [[nodiscard]] bool can_go_back() const { return !before_.empty(); }
    [[nodiscard]] bool can_go_forward() const { return !after_.empty(); }
    /// Returns the view before or after `now`. Preconditions: can_go_back() and can_go_forward(),
    /// respectively.
    [[nodiscard]] Camera back(const Camera& now);
    [[nodiscard]] Camera forward(const Camera& now);

  private:
    std::vector<Camera> before_, after_;  // nearest last
};

/// The source of a document that has no file of its own: a lesson.
struct DocumentSource {
    std::string title, path;
};

struct Editor {
    SceneDocument document;      // `document.scene` is what panels edit
    Scene saved;                 // the scene as last opened or saved
    Camera saved_edited_camera;  // History::edited_camera() at that time
    History history;
    ViewHistory views;
    bool edits_camera = false;  // the camera's numbers are being edited, which is an edit, not a view change
    DocumentSource source;
    Selection selection;
    std::optional<Scene> valid;             // the last state of the scene that a file can represent
    std::optional<FollowedItems> followed;  // nullopt until the scene is drawn for the first time
    std::unique_ptr<Editor> before;         // the previous document, until this one has been drawn; then null

    [[nodiscard]] Scene& scene() { return document.scene; }
    [[nodiscard]] const Scene& scene() const { return document.scene; }
    /// Whether there are edits that are not in a file. A view change is not an edit.
    [[nodiscard]] bool unsaved() const {
        return !same_but_camera(document.scene, saved) || history.edited_camera() != saved_edited_camera;
    }
    /// Returns file_title() of its path.
    [[nodiscard]] std::string title() const;
    /// True if the document is already a scene file, so saving needs no question.
    [[nodiscard]] bool has_scene_file() const;
};

/// Returns a file's name for titles and questions; "New scene" without a file. It is on one line and has at
/// most 80 characters, so that a long path does not push out other text.
[[nodiscard]] std::string file_title(const std::string& path);

/// Opens a document with a fresh history; `before` keeps the previous one.
void take_document(Editor& editor, SceneDocument document);

/// Saves `scene`, the edited scene or the part of it that can be opened again (as_made), as a scene file.
/// Appends ".json" to a name without it.
[[nodiscard]] std::optional<Problem> save_file(Editor& editor, std::string path, const Scene& scene);

/// Whether the document's file exists and has changed since it was last opened or saved: saving would
/// overwrite changes made by another program or window.
[[nodiscard]] bool changed_by_another(const Editor& editor);

/// Reverts edits that would make the scene's file invalid, and returns the problem: a number outside its
/// field's range, or a violated condition. So the scene can be saved, copied and recovered after any edit.
[[nodiscard]] std::optional<Problem> take_back_invalid(Editor& editor);

/// Loads meshes that an edit left unloaded. On a problem, restores the history's newest step.
[[nodiscard]] std::optional<Problem> settle(Editor& editor);

/// Records the changes since the last step, as an edit or as a view change. `join`: they continue the last
/// such change. Returns true if it was an edit.
bool remember_step(Editor& editor, bool join);

/// Goes one step back or forward; false if there is none. The view does not change, unless the step edited
/// the camera.
bool undo(Editor& editor);
bool redo(Editor& editor);

/// Returns the scene of a window without a file: a ball, a sun fixed in the world and a bulb attached to the
/// camera.
[[nodiscard]] SceneDocument first_scene();

// Closing a scene that is not a user file, such as an example, does not ask whether to save its changes.
// Instead, the changes are kept here until the window closes.

struct UiState;

struct ChangedScene {
    std::string title;
    SceneDocument document;  // the document as opened
    Scene changed;
};

struct RecentlyChanged {
    std::vector<ChangedScene> list;  // newest first, one per title
};

/// Whether the open document's changes may be dropped without asking, because it is an example.
[[nodiscard]] bool drops_changes(const UiState& state);
/// Keeps the open document's changes.
void keep_changes(UiState& state, const std::string& title);
/// Opens a changed scene again, asking first; undo restores the unchanged one.
void reopen_changed(UiState& state, const ChangedScene& changed);

}  // namespace glint
