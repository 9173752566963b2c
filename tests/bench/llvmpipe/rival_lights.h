#pragma once
// The scene's lights in the layout of light.glsl's uniform block.

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "models/scene/scene.h"

namespace glint::bench {

struct ShaderLight {
    glm::vec4 place, falloff, axis, diffuse, specular;
};

/// "#define POINTS 5" and the like. Throws std::runtime_error for a light that the shaders do not support.
[[nodiscard]] std::string light_counts(const Scene& scene);

/// The block's bytes as vec4s: point lights, directional lights, spots, then the unlit colour.
void fill_lights(std::vector<glm::vec4>& block, const Scene& scene, const glm::mat4& view);

}  // namespace glint::bench
