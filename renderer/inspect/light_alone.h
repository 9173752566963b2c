#pragma once
// A scene of one light, for what is measured light by light.

#include "models/scene/scene.h"

namespace glint {

/// The light, on, white and of intensity 1, whatever its own diffuse and specular colours are.
[[nodiscard]] inline Light white(Light light) {
    light.enabled = true;
    light.intensity = 1;
    light.diffuse = light.specular = glm::vec3(1);
    return light;
}

/// The scene's camera and shading with this light, on, as the only one, and no objects.
[[nodiscard]] inline Scene alone(const Scene& scene, const Light& light) {
    Scene s;
    s.camera = scene.camera;
    s.shading = scene.shading;
    s.lights = {light};
    s.lights[0].enabled = true;
    return s;
}

}  // namespace glint
