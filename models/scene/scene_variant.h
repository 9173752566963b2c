#pragma once
// A document's scene with something else in it: for sheets over parameters and for derivatives by numbers.

#include <vector>

#include "models/scene_file/scene_file.h"

namespace glint {

/// The scene with the assignments applied, as `--set` would, to its text with every key written out. Meshes
/// that the document has loaded are shared where their source stays; others are loaded. What is wrong in an
/// assignment has the file "--set".
[[nodiscard]] Result<Scene> scene_variant(const SceneDocument& document,
                                          const std::vector<Assignment>& assignments);

}  // namespace glint
