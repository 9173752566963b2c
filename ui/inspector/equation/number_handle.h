#pragma once
// A number of the scene that can be dragged where it stands in the equation.

#include <string>

#include "models/fields/scene_numbers.h"
#include "models/scene/scene.h"

namespace glint {

/// Valid while the scene's lists do not change.
struct NumberHandle {
    SceneNumber number;  // with its place
    std::string name;    // "shininess of Teapot"
};
/// The number at `pointer` of the scene, named by its keys and its light's or object's name. Precondition: it
/// exists.
[[nodiscard]] NumberHandle number_handle(Scene& scene, const std::string& pointer);

}  // namespace glint
