#pragma once
// Loads documents and meshes in the background: the present scene stays until the new one is complete.

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

/// A mesh being loaded. Until then its object shows the old mesh.
struct AwaitedMesh {
    MeshSource wanted, before;
    MeshPtr mesh_before;  // null: no object waits, a new one will be made from it
};

/// An orphaned autosave, loaded like a file.
struct Recovery {
    std::string autosave;            // its path
    std::shared_ptr<Scene> in_file;  // the contents of its file, which are older than the copy; empty: no
                                     // file
};

/// A file being opened.
struct Opening {
    std::string path;
    JobPtr<SceneDocument> job;
    std::function<void(UiState&)> opened = {};  // called once it is the open document; may be null
};

struct Loading {
    JobPtr<SceneDocument> document;        // being opened
    std::optional<Recovery> recovery;      // if `document` or `loaded` is a copy
    std::function<void(UiState&)> opened;  // Opening::opened
    std::string path;                      // of the document being opened, or of the last one
    std::string failed;                    // that path, if it could not be opened or drawn
    Scene scene_then;                      // the present scene when it began
    std::optional<SceneDocument> loaded;   // complete, and waiting for the answer to "save changes?"
    JobPtr<SceneDocument> meshes;          // of `awaited`
    std::vector<AwaitedMesh> awaited;
    std::vector<Object> known;  // the edited scene's objects after poll_loads(): show what an object without
                                // a mesh was before the edit
    double since = 0;           // ImGui time when the newest of them began

    [[nodiscard]] bool active() const { return document || meshes; }
};

/// Begins to open a scene, with the assignments applied to it, a mesh, or a file type of a feature.
[[nodiscard]] Opening opening_of(const std::string& path, const std::vector<Assignment>& assignments = {});

/// Waits for a file as if it had been opened in the window, whose present scene stays until then; cancels any
/// other opening.
void await_opening(UiState& state, Opening opening);

/// Begins to open a file; cancels any other opening.
void begin_open(UiState& state, const std::string& path);

/// Begins to recover an orphaned autosave; the document then counts as unsaved.
void recover_autosave(UiState& state, const std::string& path);

/// Begins to load `source` and assigns the mesh to object `index`; a negative index adds an object.
void begin_mesh(UiState& state, const MeshSource& source, int index);

/// Collects finished loads, once a frame, before anything is drawn. Meshes that an edit left unloaded are
/// made at once if that is quick, else loading begins. A problem is reported as a notification, and the scene
/// stays.
void poll_loads(UiState& state);
/// The part of poll_loads() that concerns meshes: ui/document/awaited_meshes.cpp.
void poll_meshes(UiState& state);

/// Whether an object waits for its mesh, or will from the next frame on: no undo step yet.
[[nodiscard]] bool awaits_mesh(const UiState& state);

/// Returns `scene` with each object that still waits for a mesh as it is visible, so that the scene can be
/// opened again and gives the picture on the screen. During loading this scene is saved, exported or kept.
/// `scene` is the edited one or shares its objects.
[[nodiscard]] Scene as_made(const UiState& state, Scene scene);
/// Returns the open document with that scene.
[[nodiscard]] SceneDocument document_as_made(const UiState& state);

/// Cancels all loads; the scene is as before them.
void cancel_loads(UiState& state);
/// Cancels those of meshes: each object gets the source of its present mesh again.
void give_up_meshes(UiState& state);
/// Reverts the edit that needed a mesh and is not a step yet. Other edits made in the meantime become a step
/// and are undone too: it can be redone. The view stays.
void undo_awaiting(UiState& state);

/// Draws the progress of a job that began at `since` (ImGui time), over the middle of the picture's upper
/// edge. True when the user cancels it.
[[nodiscard]] bool progress_panel(const AnyJob& job, double since, const Rect& picture);

/// Draws the progress bar of the present load, over the middle of the picture's upper edge.
void loading_panel(UiState& state, const Rect& picture);

/// Opens the first copy of unsaved work that a crash left, deletes it, or asks again at the next start.
/// Precondition: there is one.
enum class CopyAnswer { Recover, Discard, NotNow };
void answer_copy(UiState& state, CopyAnswer answer);

/// Offers to recover unsaved work after a crash, in the same place, while nothing is being loaded.
void recovery_panel(UiState& state, const Rect& picture);

/// "reading 12 of 37 MB", "building the mesh: 400000 faces": the progress of a load.
[[nodiscard]] std::string progress_words(const LoadProgress& progress);

/// The completed share of the load, from 0 to 1; negative if unknown.
[[nodiscard]] float progress_share(const LoadProgress& progress);

/// Whether a primitive is made in a few milliseconds.
[[nodiscard]] bool is_quick(const PrimitiveMesh& mesh);
/// Whether the object has no mesh, and making it takes longer than is_quick() allows.
[[nodiscard]] bool awaits_slow_mesh(const Object& object);

}  // namespace glint
