#pragma once
// What lights a mesh, or a file of meshes, that comes without lights. Inside models/ only.

#include <vector>

#include "models/scene/light.h"

namespace glint {

/// Returns a directional light in world coordinates and a dimmer point light at the viewer.
[[nodiscard]] std::vector<Light> default_lights();

}  // namespace glint
