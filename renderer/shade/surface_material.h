#pragma once
// Converts a material to the kernels' input, including mistakes.

#include <glm/vec3.hpp>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"

namespace glint {

/// The maximum shininess in OpenGL 2.1.
inline constexpr float opengl_max_shininess = 128;

[[nodiscard]] inline Float3 to_float3(const glm::vec3& c) { return {c.x, c.y, c.z}; }
[[nodiscard]] inline Float3 to_float3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The material with mistakes applied.
[[nodiscard]] Material mistaken_material(const Mistakes& mistakes, Material material);

/// A material in the equation's form, without k_a I_a: `global_ambient` is 0.
[[nodiscard]] SurfaceMaterial surface_material(const Material& material);

/// The square of the cosine whose power is 2^-24, the last bit of a highlight of 1. For a shininess of 0, for
/// which every cosine gives a highlight (0^0 is 1), the lowest float, which is less than any signed square.
[[nodiscard]] float min_cosine_squared(float shininess);

}  // namespace glint
