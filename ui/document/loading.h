#pragma once
// Loads documents and meshes in the background. The current scene stays open until the new one is complete.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/document/editor.h"
#include "ui/document/job.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

/// A mesh being loaded. Its object shows the old mesh until the load ends.
struct AwaitedMesh {
    MeshSource wanted, before;
    MeshPtr mesh_before;  // null: no object waits; a new object will get the mesh
};

/// An orphaned autosave, loaded like a file.
struct Recovery {
    std::string autosave;            // path of the autosave
    std::shared_ptr<Scene> in_file;  // the scene in the document's file, older than the copy; null: no file
};

/// A file being opened.
struct Opening {
    std::string path;
    JobPtr<SceneDocument> job;
    std::function<void(UiState&)> opened = {};  // called once the document is open; may be null
};

struct Loading {
    JobPtr<SceneDocument> document;        // being opened
    std::optional<Recovery> recovery;      // set if `document` or `loaded` is a copy
    std::function<void(UiState&)> opened;  // Opening::opened
    std::string path;                      // path of the document being opened, or of the last one
    std::string failed;                    // `path`, if that file could not be opened or drawn
    Scene scene_then;                      // the current scene when the load began
    std::optional<SceneDocument> loaded;   // loaded, and waiting for the answer to "save changes?"
    JobPtr<SceneDocument> meshes;          // the meshes of `awaited`
    std::vector<AwaitedMesh> awaited;
    std::vector<Object> known;  // the edited scene's objects after poll_loads(), before the next edit
    double since = 0;           // ImGui time at which the newest load began

    [[nodiscard]] bool active() const { return document || meshes; }
};

/// Begins to open a mesh, a file of a type that a feature opens, or a scene with the assignments applied to
/// it.
[[nodiscard]] Opening opening_of(const std::string& path, const std::vector<Assignment>& assignments = {});

/// Opens a file in the background as if the user had opened it in the window. The current scene stays open
/// until the file is loaded. Cancels the opening of any other file.
void await_opening(UiState& state, Opening opening);

/// Begins to open a file; cancels the opening of any other file.
void begin_open(UiState& state, const std::string& path);

/// Begins to recover an orphaned autosave; the document then counts as unsaved.
void recover_autosave(UiState& state, const std::string& path);

/// Begins to load `source`, whose mesh is then assigned to object `index`; a negative index adds an object.
void begin_mesh(UiState& state, const MeshSource& source, int index);

/// Collects finished loads, once per frame, before anything is drawn. A mesh that an edit requires is built
/// at once if that is quick; otherwise a load begins. A problem is reported as a notification, and the scene
/// does not change.
void poll_loads(UiState& state);
/// The part of poll_loads() that handles meshes.
void poll_meshes(UiState& state);

/// Whether an object is waiting for its mesh, or will be from the next frame on. Such an edit is not yet an
/// undo step.
[[nodiscard]] bool awaits_mesh(const UiState& state);

/// Returns `scene` with the visible state of each object that is still waiting for a mesh, so that it can be
/// opened again and produces the picture on the screen. This scene is the one saved, exported or kept during
/// loading. `scene` is the edited one or shares its objects.
[[nodiscard]] Scene as_made(const UiState& state, Scene scene);
/// Returns the open document with the scene of as_made().
[[nodiscard]] SceneDocument document_as_made(const UiState& state);

/// Cancels all loads and restores the scene to its state before them.
void cancel_loads(UiState& state);
/// Cancels the loads of meshes: each object gets the source of its current mesh again.
void give_up_meshes(UiState& state);
/// Reverts the edit that needs a mesh and is not yet a step. Other edits made in the meantime become a step,
/// which is undone too; redo restores it. The view does not change.
void undo_awaiting(UiState& state);

/// Draws the progress of a job that began at `since` (ImGui time), centred at the picture's upper
/// edge. True when the user cancels it.
[[nodiscard]] bool progress_panel(const AnyJob& job, double since, const Rect& picture);

/// Draws the progress bar of the current load, centred at the picture's upper edge.
void loading_panel(UiState& state, const Rect& picture);

/// The possible answers to the offer to recover the first copy that a crash left: open it, delete it, or ask
/// again at the next start. Precondition: there is one.
enum class CopyAnswer { Recover, Discard, NotNow };
void answer_copy(UiState& state, CopyAnswer answer);

/// Offers to recover unsaved work after a crash, in the place of the progress bar, while nothing is loading.
void recovery_panel(UiState& state, const Rect& picture);

/// Returns the completed fraction of the load, from 0 to 1; negative if unknown.
[[nodiscard]] float progress_share(const LoadProgress& progress);

/// Whether building the primitive takes only a few milliseconds.
[[nodiscard]] bool is_quick(const PrimitiveMesh& mesh);
/// Whether the object has no mesh, and building it takes longer than is_quick() allows.
[[nodiscard]] bool awaits_slow_mesh(const Object& object);

}  // namespace glint
