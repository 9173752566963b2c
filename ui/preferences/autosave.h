#pragma once
// Keeps a copy of unsaved work beside the window's memory, to be found again after a crash. Each window has a
// file of its own and holds a lock while it lives: a copy whose lock is free was left by a window that is
// gone.

#include <optional>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"

namespace glint {

/// The right to a copy: a lock file beside it, held until this is destroyed or the process ends in any way.
class AutosaveLock {
  public:
    /// Takes the lock of the copy `path`, making its file; nothing when another holds it.
    [[nodiscard]] static std::optional<AutosaveLock> take(const std::string& path);
    /// Does the same for a copy that exists already. In a folder that cannot be written nobody can make a
    /// lock file: if it is missing, the copy itself is locked.
    [[nodiscard]] static std::optional<AutosaveLock> take_left(const std::string& path);
    AutosaveLock(AutosaveLock&& other) noexcept;
    AutosaveLock& operator=(AutosaveLock&& other) noexcept;
    AutosaveLock(const AutosaveLock&) = delete;
    AutosaveLock& operator=(const AutosaveLock&) = delete;
    ~AutosaveLock();  // removes the lock's file and lets go

    /// The copy that it is for.
    [[nodiscard]] const std::string& path() const { return path_; }
    /// Whether the lock's file is still there: without it another window takes the copy for one that was
    /// left.
    [[nodiscard]] bool stands() const;

  private:
    explicit AutosaveLock(const std::string& path);
    void release() noexcept;

    std::string path_, lock_;  // of the copy and of the lock's file
    int descriptor_ = -1;
};

/// A new copy's name in `folder`, locked; nothing when the folder cannot be written.
[[nodiscard]] std::optional<AutosaveLock> new_autosave(const std::string& folder);

/// The text of a copy that stands in `folder`: the document's path, what its file was like when it was opened
/// or saved, and its scene with mesh paths that lead from there.
[[nodiscard]] std::string autosave_text(const SceneDocument& document, const std::string& folder);

/// A copy that a window left behind, with its lock now ours.
struct OrphanedAutosave {
    AutosaveLock lock;
    std::string title;  // of the document: file_title() its path
    std::string when;   // it was written: "14:05", "3 May, 14:05" or "3 May 2025, 14:05"
};

/// The copies in `folder` that nobody holds, newest first. What is not a copy is passed over; locks
/// that were left without a copy are removed.
[[nodiscard]] std::vector<OrphanedAutosave> orphaned_autosaves(const std::string& folder);

/// The document of a copy, its meshes loaded; where it was opened from is its path again.
[[nodiscard]] Result<SceneDocument> open_autosave(const std::string& path);

// Several windows share the folder: only one at a time may read, change and write there (FolderLock).

/// How long a window that ends waits for another that writes; seconds.
inline constexpr double patience_at_end = 1;

}  // namespace glint
