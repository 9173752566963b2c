#pragma once
// Reads and writes entire files safely, and detects changes to files.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "models/problem.h"

namespace glint {

/// The extension that determines a file's format, with its dot and in lower case: ".png". Empty if the name
/// has none.
[[nodiscard]] std::string lower_extension(const std::string& path);

/// The system's text for an errno, for use within a line: "no such file or directory".
[[nodiscard]] std::string reason(int error);

/// A block of a file that is being read: `bytes` starting at offset `at`, in a file of `size` bytes (0 for
/// standard input).
struct FileBlock {
    std::string_view bytes;
    std::size_t at = 0, size = 0;
};
/// Called with each block before the next one is read and before memory for the entire file is reserved. A
/// problem stops the reading.
using CheckBlock = std::function<std::optional<Problem>(const FileBlock& block)>;

/// Returns the bytes of a regular file, or of standard input for "-" (once). Fails for a directory, a device,
/// a pipe, a missing file, a file longer than `max_bytes` (nothing is read), or one that `check` rejects.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t max_bytes,
                                            const CheckBlock& check = {});

/// Returns why nothing exists at `path`, following links; nullopt if a file of any kind exists.
[[nodiscard]] std::optional<Problem> why_not_there(const std::string& path, const char* expected);

/// Writes a new file in the target's directory, syncs it to the disk and renames it over the target, so a
/// crash or a full disk leaves the old file intact. The old file's permission bits are kept, and its owner
/// and group if the system allows it. If the group cannot be kept, the new group and all others get only the
/// rights that the old file gave to both its group and others. Until the permissions are set, nobody else can
/// read the new file. A symbolic link stays, and the file that it names is replaced; other hard links to the
/// old file keep the old bytes. A target that is not a regular file (a pipe, a device) is written in place;
/// "-" is standard output, and so is /dev/stdout. A pipe without a reader is reported as a problem, not as a
/// signal. On failure the new file is removed and the problem names the path and the reason.
[[nodiscard]] Result<std::monostate> write_file(const std::string& path, std::string_view bytes);

/// Like write_file(), but rejects a pipe: a window must not block until a reader appears.
[[nodiscard]] Result<std::monostate> write_file_at_once(const std::string& path, std::string_view bytes);

/// True for standard output under any name that write_file() recognizes.
[[nodiscard]] bool is_standard_output(const std::string& path);

/// Returns why write_file() would fail, if that is known in advance; otherwise nullopt. Call it before
/// lengthy work that writes a file at the end. Changes nothing.
[[nodiscard]] std::optional<Problem> why_not_writable(const std::string& path);

/// Returns the file that write_file() would replace, following links: one name for all spellings of the path.
/// Empty for streams, pipes and devices, which are not replaced, and for paths that cannot be written.
[[nodiscard]] std::string replaced_file(const std::string& path);

/// Whether write_file() would replace a file that read_file() has read, following links. A command must not
/// replace its own input.
[[nodiscard]] bool was_read(const std::string& path);

/// Identifies one state of a file. Writing the file, in place or by renaming another one over it, changes its
/// stamp.
struct FileStamp {
    std::uint64_t device = 0, inode = 0;
    std::int64_t size = -1;        // bytes; -1: the file does not exist
    std::int64_t modified_ns = 0;  // since 1970
    bool operator==(const FileStamp&) const = default;

    [[nodiscard]] bool exists() const { return size >= 0; }
};

/// The stamp of the file at `path`, following links. A default stamp if it does not exist or cannot be
/// queried.
[[nodiscard]] FileStamp file_stamp(const std::string& path);

/// Convert a stamp to text (four numbers), for storing in a file, and back. Any other text yields nullopt.
[[nodiscard]] std::string stamp_text(const FileStamp& stamp);
[[nodiscard]] std::optional<FileStamp> stamp_of(const std::string& text);

// A file that another program writes, such as an editor or a student's program.

/// Reports each new state of the file once, after its size and time have stopped changing, so a file that is
/// written in place is not read half-written, and one that is replaced by renaming is not reported as missing
/// in between.
class WatchedFile {
  public:
    using Time = std::chrono::steady_clock::time_point;
    enum class Change { None, Written, Vanished };

    /// The state that the file at `path` has now is not reported.
    explicit WatchedFile(std::string path, std::chrono::milliseconds settles = std::chrono::milliseconds(100))
        : path_(std::move(path)), settles_(settles), known_(file_stamp(path_)), seen_(known_) {}

    [[nodiscard]] const std::string& path() const { return path_; }
    /// To be called several times per second, with the current time.
    [[nodiscard]] Change update(Time now) {
        const FileStamp stamp = file_stamp(path_);
        if (stamp != seen_) since_ = now;
        seen_ = stamp;
        if (stamp == known_ || now - since_ < settles_) return Change::None;
        known_ = stamp;
        return stamp.exists() ? Change::Written : Change::Vanished;
    }

  private:
    std::string path_;
    std::chrono::milliseconds settles_;
    FileStamp known_, seen_;  // the state that was last reported, and the current one
    Time since_;              // when `seen_` was first seen
};

}  // namespace glint
