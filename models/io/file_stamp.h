#pragma once
// Whether a file is still the one that was read or written.

#include <cstdint>
#include <optional>
#include <string>

namespace glint {

/// One state of a file. Whoever writes it, in place or by renaming another into its place, changes this.
struct FileStamp {
    std::uint64_t device = 0, inode = 0;
    std::int64_t size = -1;        // bytes; -1: there is no file
    std::int64_t modified_ns = 0;  // since 1970
    bool operator==(const FileStamp&) const = default;

    [[nodiscard]] bool exists() const { return size >= 0; }
};

/// The file that `path` names, links followed. A default stamp when there is none or it cannot be asked.
[[nodiscard]] FileStamp file_stamp(const std::string& path);

/// Write a stamp as four numbers, to be kept in a file, and read it back; nothing when `text` is anything
/// else.
[[nodiscard]] std::string stamp_text(const FileStamp& stamp);
[[nodiscard]] std::optional<FileStamp> stamp_of(const std::string& text);

}  // namespace glint
