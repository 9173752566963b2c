#pragma once
// The scenes of a folder, in the order in which a person would count them.

#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// Numbers within names count as numbers, capitals do not: "Step 2" < "step 10" < "step 10b".
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

/// The scene files (.json) of a folder in that order, as paths. Hidden ones are left out; empty when the
/// folder cannot be read.
[[nodiscard]] std::vector<std::string> folder_scenes(const std::string& folder);

/// The scene `step` places after `path` (before it, when negative) in its folder; for a path that is not in
/// the list the one that would be next to it. Empty when there is none.
[[nodiscard]] std::string scene_beside(const std::string& path, int step);

}  // namespace glint
