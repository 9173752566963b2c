#pragma once
// Rules for includes: they only point down, app -> ui -> renderer -> models, and the window's libraries stay
// in the folders that own them (docs/architecture.md).

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// The violations in the includes of one source file, one line each: "ui/x.cpp:3: includes app/y.h; ...".
/// `path` is relative to the project's root, with forward slashes; `text` is the file's content.
[[nodiscard]] std::vector<std::string> forbidden_includes(std::string_view path, std::string_view text);

/// The chain of files through which `from` includes `to`, including these two; empty if it does not. `files`
/// maps paths to texts.
[[nodiscard]] std::vector<std::string> way_of_includes(const std::map<std::string, std::string>& files,
                                                       const std::string& from, const std::string& to);
