#pragma once
// Closing a scene that is not a user file, such as an example, does not ask whether to save its changes.
// Instead, the changes are kept here until the window closes.

#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"

namespace glint {

struct UiState;

struct ChangedScene {
    std::string title;
    SceneDocument document;  // as opened
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
