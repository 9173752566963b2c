#pragma once
// Converts between GLM vectors and those of the equation.

#include <glm/vec3.hpp>

#include "renderer/simd/vec3.h"

namespace glint::inline GLINT_ISA {

inline Vec3<float> to_vec(const glm::vec3& v) { return {v.x, v.y, v.z}; }
template <Number F> glm::vec3 to_glm(const Vec3<F>& v) { return glm::vec3(v.x, v.y, v.z); }

}  // namespace glint::inline GLINT_ISA
