#pragma once
// Documents and meshes that are being loaded while the window goes on: the scene in hand stays whole until
// what is new is whole too.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/document/editor.h"
#include "ui/preferences/job.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

/// A mesh on its way. The object that wants it shows until then the mesh that it had.
struct AwaitedMesh {
    MeshSource wanted, before;
    MeshPtr mesh_before;  // null: no object waits, a new one will be made of it
};

struct Loading {
    std::unique_ptr<LoadJob> document;    // to be opened
    Scene scene_then;                     // what was in hand when it began
    std::optional<SceneDocument> loaded;  // whole, and waiting for the answer to "save changes?"
    std::unique_ptr<LoadJob> meshes;      // of `awaited`
    std::vector<AwaitedMesh> awaited;
    std::vector<std::unique_ptr<LoadJob>> left;  // cancelled, and not ended yet
    double since = 0;                            // ImGui's time when the newest of them began

    [[nodiscard]] bool active() const { return document || meshes; }
};

/// Begins to open a file; what was being opened is cancelled.
void begin_open(UiState& state, const std::string& path);

/// Begins to load `source` and gives it to object `index` when it is there; a negative index makes a new
/// object of it.
void begin_mesh(UiState& state, const MeshSource& source, int index);

/// Once a frame, before anything is drawn: takes what has come. Meshes that an edit left unloaded are made
/// at once where that is quick, else they are begun. A problem is a notification, and the scene stays.
void poll_loads(UiState& state);

/// Whether an object waits for its mesh: no undo step yet.
[[nodiscard]] bool awaits_mesh(const UiState& state);

/// Ends all loads; the scene is as before them.
void cancel_loads(UiState& state);

/// The bar that says what is being loaded, in the middle of the window's upper part.
void loading_panel(UiState& state, const Rect& picture);

/// Whether a primitive is made in a few milliseconds.
[[nodiscard]] bool is_quick(const PrimitiveMesh& mesh);

}  // namespace glint
