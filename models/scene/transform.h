#pragma once
// Where an object stands in the world: M = T Rz Ry Rx S (docs/interface.md, "Objects").

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace glint {

struct Transform {
    glm::vec3 translate{0};
    glm::vec3 rotate_deg{0};  // about x, then y, then z
    glm::vec3 scale{1};       // no component 0; a negative one mirrors
    bool operator==(const Transform&) const = default;
};

/// World coordinates from object coordinates, in double (see view_from_world).
[[nodiscard]] glm::dmat4 world_from_object(const Transform& transform);

}  // namespace glint
