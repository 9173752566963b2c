#pragma once
// How the scene is shaded, and how it is shown.

#include "models/scene/scene.h"

namespace glint {

/// Each edits its value and says whether it did.
[[nodiscard]] bool shading_panel(Shading& shading, glm::vec3& global_ambient);
[[nodiscard]] bool display_panel(Display& display);

}  // namespace glint
