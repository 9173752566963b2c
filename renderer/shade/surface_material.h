#pragma once
// Converts a material to what the kernels take, changed as a mistake changes it.

#include <glm/vec3.hpp>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"

namespace glint {

/// OpenGL 2.1 takes a shininess up to 128.
inline constexpr float opengl_max_shininess = 128;

[[nodiscard]] inline Float3 to_float3(const glm::vec3& c) { return {c.x, c.y, c.z}; }
[[nodiscard]] inline Float3 to_float3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The material as the equation takes it: as it is, but for mistakes.
[[nodiscard]] Material mistaken_material(const Mistakes& mistakes, Material material);

/// A material as the equation sees it, without k_a I_a: `global_ambient` stays 0.
[[nodiscard]] SurfaceMaterial surface_material(const Material& material);

/// The square of the cosine whose power is 2^-24, the last bit of a highlight of 1; the lowest float,
/// below every square with its sign, for a shininess of 0, where every cosine counts (0^0 is 1).
[[nodiscard]] float min_cosine_squared(float shininess);

}  // namespace glint
