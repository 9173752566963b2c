#include "models/scene/transform.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace glint {

glm::dmat4 world_from_object(const Transform& transform) {
    const glm::dvec3 angle = glm::radians(glm::dvec3(transform.rotate_deg));
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), glm::dvec3(transform.translate));
    m = glm::rotate(m, angle.z, {0, 0, 1});
    m = glm::rotate(m, angle.y, {0, 1, 0});
    m = glm::rotate(m, angle.x, {1, 0, 0});
    return glm::scale(m, glm::dvec3(transform.scale));
}

}  // namespace glint
