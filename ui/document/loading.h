#pragma once
// Loads documents and meshes while the window goes on: the scene in hand stays until the new one is complete.

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

/// A mesh that is being loaded. Until then the object that wants it shows its old mesh.
struct AwaitedMesh {
    MeshSource wanted, before;
    MeshPtr mesh_before;  // null: no object waits, a new one will be made of it
};

/// An autosave that a window left behind, loaded like a file.
struct Recovery {
    std::string autosave;            // its path
    std::shared_ptr<Scene> in_file;  // what its file has, which the copy is newer than; empty: no file
};

/// A file that is being opened.
struct Opening {
    std::string path;
    JobPtr<SceneDocument> job;
    std::function<void(UiState&)> opened = {};  // goes on once it is the open document; null: nothing does
};

struct Loading {
    JobPtr<SceneDocument> document;        // to be opened
    std::optional<Recovery> recovery;      // where `document` or `loaded` is a copy
    std::function<void(UiState&)> opened;  // Opening::opened
    std::string path;                      // of what is being opened, or was
    std::string failed;                    // that path, if it could not be opened or drawn
    Scene scene_then;                      // what was in hand when it began
    std::optional<SceneDocument> loaded;   // whole, and waiting for the answer to "save changes?"
    JobPtr<SceneDocument> meshes;          // of `awaited`
    std::vector<AwaitedMesh> awaited;
    std::vector<Object> known;  // the edited scene's as poll_loads() left them. By these it tells what an
                                // object without a mesh was before the edit
    double since = 0;           // ImGui's time when the newest of them began

    [[nodiscard]] bool active() const { return document || meshes; }
};

/// Begins to open a scene, with the assignments applied to it, a mesh, or what a feature opens.
[[nodiscard]] Opening opening_of(const std::string& path, const std::vector<Assignment>& assignments = {});

/// Waits for a file as if it had been opened in the window, whose present scene stays until then; what was
/// being opened is cancelled.
void await_opening(UiState& state, Opening opening);

/// Begins to open a file; what was being opened is cancelled.
void begin_open(UiState& state, const std::string& path);

/// Begins to recover an autosave that a window left behind; the document then counts as unsaved.
void recover_autosave(UiState& state, const std::string& path);

/// Begins to load `source` and gives the mesh to object `index`; a negative index makes a new object of it.
void begin_mesh(UiState& state, const MeshSource& source, int index);

/// Takes finished loads, once a frame, before anything is drawn. Meshes that an edit left unloaded are made
/// at once if that is quick, else loading begins. A problem is a notification, and the scene stays.
void poll_loads(UiState& state);
/// The part of poll_loads() that concerns meshes: ui/document/awaited_meshes.cpp.
void poll_meshes(UiState& state);

/// Whether an object waits for its mesh, or will from the next frame on: no undo step yet.
[[nodiscard]] bool awaits_mesh(const UiState& state);

/// Returns `scene` with each object that still waits for a mesh as it is seen, so that the scene can be
/// opened again and its picture is the one on the screen. Meanwhile this is what is saved, exported or kept.
/// `scene` is the edited one or shares its objects.
[[nodiscard]] Scene as_made(const UiState& state, Scene scene);
/// Returns the open document with that scene.
[[nodiscard]] SceneDocument document_as_made(const UiState& state);

/// Ends all loads; the scene is as before them.
void cancel_loads(UiState& state);
/// Ends those of meshes: each object is again what its mesh was made of.
void give_up_meshes(UiState& state);
/// Takes back the edit that asked for a mesh, of which there is no step yet. Whatever was edited meanwhile
/// becomes a step and is undone, too: it can be redone. The view stays.
void undo_awaiting(UiState& state);

/// Draws how far a job has come that began at `since` (ImGui's time), over the middle of the picture's upper
/// edge. True when the user cancels it.
[[nodiscard]] bool progress_panel(const AnyJob& job, double since, const Rect& picture);

/// Draws the bar that says what is being loaded, over the middle of the picture's upper edge.
void loading_panel(UiState& state, const Rect& picture);

/// Opens the first copy of unsaved work that a crash left, deletes it, or asks again at the next start.
/// Precondition: there is one.
enum class CopyAnswer { Recover, Discard, NotNow };
void answer_copy(UiState& state, CopyAnswer answer);

/// Offers to recover the work that a crash interrupted, at the same place, while nothing is being loaded.
void recovery_panel(UiState& state, const Rect& picture);

/// "reading 12 of 37 MB", "building the mesh: 400000 faces": how far a load has come.
[[nodiscard]] std::string progress_words(const LoadProgress& progress);

/// How much of the load is done, from 0 to 1; negative when that is not known.
[[nodiscard]] float progress_share(const LoadProgress& progress);

/// Whether a primitive is made in a few milliseconds.
[[nodiscard]] bool is_quick(const PrimitiveMesh& mesh);
/// Whether the object has no mesh, and making it takes longer than is_quick() allows.
[[nodiscard]] bool awaits_slow_mesh(const Object& object);

}  // namespace glint
