#pragma once
// A number of the scene that can be dragged within the equation.

#include <string>

#include "models/fields/scene_numbers.h"
#include "models/scene/scene.h"

namespace glint {

/// Valid while the scene's lists do not change.
struct NumberHandle {
    SceneNumber number;
    std::string name;  // "shininess of Teapot"
};

/// A scene whose numbers are shown, and the same scene for editing; the latter is null if read-only.
struct HandledScene {
    const Scene& shown;
    Scene* edited = nullptr;
};
/// The number at `pointer` of the scene, named by its keys and its light's or object's name, without a target
/// if the scene is read-only. Precondition: it exists.
[[nodiscard]] NumberHandle number_handle(const HandledScene& scene, const std::string& pointer);

}  // namespace glint
