#pragma once
// The copy of unsaved work: one per process, in the settings folder, so that it can be found after a crash. A
// process locks its copy (flock on a file next to it) while it runs; an unlocked copy was left behind by a
// process that has ended.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"

namespace glint {

/// The right to write, offer or remove the copy `path`. The lock is released when its last owner is destroyed
/// or the process ends for any reason.
struct AutosaveLock {
    std::string path;
    std::shared_ptr<const int> file;
};

/// Creates a new copy in `folder`, locked and not yet written. Returns nullopt if the folder is not writable.
[[nodiscard]] std::optional<AutosaveLock> new_autosave(const std::string& folder);

/// Returns the text of a copy in `folder`: the document's path, its file's stamp from when it was opened or
/// saved, and its scene with mesh paths relative to that folder.
[[nodiscard]] std::string autosave_text(const SceneDocument& document, const std::string& folder);

/// A copy left by a process that has ended, now locked by this one.
struct OrphanedAutosave {
    AutosaveLock lock;
    std::string title;  // the document's title: file_title() of its path
    std::string when;   // when the copy was written, such as "2025-05-03 14:05"
};

/// Returns the copies in `folder` that no process has locked, newest first. Skips files that are not copies.
[[nodiscard]] std::vector<OrphanedAutosave> orphaned_autosaves(const std::string& folder);

/// Opens a copy as a document with its original path, and loads its meshes.
[[nodiscard]] Result<SceneDocument> open_autosave(const std::string& path);

}  // namespace glint
