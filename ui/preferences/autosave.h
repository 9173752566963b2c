#pragma once
// The copy of unsaved work: one per process, in the settings folder, so that it can be found after a crash. A
// process locks its copy (flock on a file next to it) while it runs; an unlocked copy was left by a process
// that has ended.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"

namespace glint {

/// The right to write, offer or remove the copy `path`. The lock is released when its last owner is destroyed
/// or the process ends in any way.
struct AutosaveLock {
    std::string path;
    std::shared_ptr<const int> file;
};

/// A new copy in `folder`, locked and not yet written; nothing when the folder is not writable.
[[nodiscard]] std::optional<AutosaveLock> new_autosave(const std::string& folder);

/// The text of a copy in `folder`: the document's path, its file's stamp when it was opened or saved, and its
/// scene with mesh paths relative to that folder.
[[nodiscard]] std::string autosave_text(const SceneDocument& document, const std::string& folder);

/// A copy left by a process that has ended, now locked by this one.
struct OrphanedAutosave {
    AutosaveLock lock;
    std::string title;  // title of the document: file_title() of its path
    std::string when;   // when it was written: "2025-05-03 14:05"
};

/// The copies in `folder` that no process has locked, newest first. Skips anything that is not a copy.
[[nodiscard]] std::vector<OrphanedAutosave> orphaned_autosaves(const std::string& folder);

/// The document of a copy, with its meshes loaded and its original path.
[[nodiscard]] Result<SceneDocument> open_autosave(const std::string& path);

}  // namespace glint
