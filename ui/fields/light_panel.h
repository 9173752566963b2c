#pragma once
// One light's numbers.

#include <string>

#include "models/scene/scene.h"
#include "ui/picture/handles/light_place.h"

namespace glint {

/// Edits the light and says whether it did. `pointer`: its place in the scene file, "/lights/1". Kind and
/// space change so that the light stays where it is, as seen in `map` and `dome`.
[[nodiscard]] bool light_panel(Light& light, const std::string& pointer, const Camera& camera,
                               const Dome& dome, const ScreenMap& map);

}  // namespace glint
