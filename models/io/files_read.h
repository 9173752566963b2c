#pragma once
// The files that the program has read: a command must not replace one of them by what it made of it.

#include <string>

namespace glint {

/// Is called by whatever has opened a file for reading, on any thread.
void note_read(const std::string& path);

/// Whether write_file(path) would replace a file that was noted; links are followed.
[[nodiscard]] bool was_read(const std::string& path);

}  // namespace glint
