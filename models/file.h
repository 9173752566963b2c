#pragma once
// Whole files in and out, safely.

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "models/problem.h"

namespace glint {

/// The bytes of a regular file, or of standard input for "-". A directory, a device, a pipe, a missing file
/// or one longer than `max_bytes` is a problem.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

/// Writes beside the target and renames into place, so that a crash or a full disk leaves the old file whole.
/// The old file's permission bits are kept; a symbolic link stays, and what it names is replaced.
/// A target that is no regular file (a pipe, a device) is written straight through; "-" is standard output,
/// and so is /dev/stdout. A reader that has gone is a problem, not a signal. On failure nothing is left
/// behind and the problem names the path and the reason.
[[nodiscard]] Result<std::monostate> write_file(const std::string& path, std::string_view bytes);

}  // namespace glint
