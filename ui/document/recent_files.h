#pragma once
// The files opened or saved last, newest first: a list in a file that several windows share and that anyone
// may have written anything into.

#include <string>
#include <vector>

namespace glint {

inline constexpr std::size_t most_recent_files = 12;

/// The list in a JSON text: absolute paths without control characters, each once, at most most_recent_files.
/// What is anything else is left out.
[[nodiscard]] std::vector<std::string> read_recent_files(const std::string& text);
[[nodiscard]] std::string recent_files_text(const std::vector<std::string>& paths);

/// `paths` with `path`, made absolute, in front. "-" and an empty path are not remembered.
[[nodiscard]] std::vector<std::string> with_recent_file(std::vector<std::string> paths,
                                                        const std::string& path);

}  // namespace glint
