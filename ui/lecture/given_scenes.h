#pragma once
// The scenes that the program was given on its command line: a lecture in an order of one's own.

#include <optional>
#include <string>
#include <vector>

namespace glint {

/// PgDn and PgUp go through these, in their order, while one of them is open; without any through the open
/// scene's folder. For the whole process, before its window opens.
void give_scenes(std::vector<std::string> paths);

/// The one `step` places after `path` (before it, when negative), empty where there is none. Nothing where
/// `path` was not given.
[[nodiscard]] std::optional<std::string> given_scene_beside(const std::string& path, int step);

}  // namespace glint
