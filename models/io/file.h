#pragma once
// Whole files in and out, safely, and whether a file is still the one that was read or written.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "models/problem.h"

namespace glint {

/// The extension that tells a file's format: with its dot and in lower case, ".png"; empty where the name has
/// none.
[[nodiscard]] std::string lower_extension(const std::string& path);

/// The system's words for an errno, as they stand inside a line: "no such file or directory".
[[nodiscard]] std::string reason(int error);

/// A part of a file as it comes in: `bytes` from `at` on, of a file of `size` bytes (0 for standard input).
struct FileBlock {
    std::string_view bytes;
    std::size_t at = 0, size = 0;
};
/// Is called with each block before the next one is read and before memory is reserved for the whole file; a
/// problem ends the reading.
using CheckBlock = std::function<std::optional<Problem>(const FileBlock& block)>;

/// The bytes of a regular file, or of standard input for "-", once. A directory, a device, a pipe, a missing
/// file, one longer than `max_bytes` (of which nothing is read) or one that `check` refuses is a problem.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t max_bytes,
                                            const CheckBlock& check = {});

/// Why the system finds nothing at `path`, links followed; nothing when it finds something, of whatever kind.
[[nodiscard]] std::optional<Problem> why_not_there(const std::string& path, const char* expected);

/// Writes a new file in the target's directory, syncs it to the disk and renames it over the target, so that
/// a crash or a full disk leaves the old file whole. The old file's permission bits are kept, and its owner
/// and group where the system lets us. If the group cannot be kept, the new group and all others may only do
/// what the old file let both its group and others do. Until the permissions are set, nobody else can read
/// what is written. A symbolic link stays, and the file that it names is replaced; other hard links to the
/// old file keep the old bytes. A target that is not a regular file (a pipe, a device) is written straight
/// through; "-" is standard output, and so is /dev/stdout. A reader that has gone is a problem, not a signal.
/// On failure the new file is removed and the problem names the path and the reason.
[[nodiscard]] Result<std::monostate> write_file(const std::string& path, std::string_view bytes);

/// Does what write_file() does, but takes a pipe for a problem: a window must not wait until somebody reads.
[[nodiscard]] Result<std::monostate> write_file_at_once(const std::string& path, std::string_view bytes);

/// True for standard output under any of the names that write_file() knows it by.
[[nodiscard]] bool is_standard_output(const std::string& path);

/// Why write_file() could not write there, as far as that can be told before there is anything to write;
/// nothing when it could. For long work that ends in a file. Changes nothing.
[[nodiscard]] std::optional<Problem> why_not_writable(const std::string& path);

/// Returns the file that write_file() would replace, links followed: one name, however the path is spelt.
/// Empty for streams, pipes and devices, which are not replaced, and for paths that cannot be written.
[[nodiscard]] std::string replaced_file(const std::string& path);

/// Whether write_file() would replace a file that read_file() has read; links are followed. A command must
/// not replace its own input.
[[nodiscard]] bool was_read(const std::string& path);

/// Identifies one state of a file. Writing the file, in place or by renaming another one over it, changes its
/// stamp.
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
