#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "models/json/json_value.h"

namespace glint {

/// A vector as an array of its components.
template <class T> [[nodiscard]] JsonValue json_of(const glm::tvec2<T>& v) { return {v.x, v.y}; }
template <class T> [[nodiscard]] JsonValue json_of(const glm::tvec3<T>& v) { return {v.x, v.y, v.z}; }

}  // namespace glint
