#include "ui/limits.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace glint {
namespace {

bool is_valid_window(const Frustum& f) {
    return std::abs(f.right - f.left) > 1e-7f && std::abs(f.top - f.bottom) > 1e-7f;
}

}  // namespace

bool is_valid(const Camera& camera) {
    const glm::dvec3 away = glm::dvec3(camera.eye) - glm::dvec3(camera.target), up(camera.up);
    const double distance = glm::length(away), height = glm::length(up);
    if (!(distance > 1e-5) || !(height > 1e-5)) return false;
    if (!(glm::length(glm::cross(away, up)) > 1e-3 * distance * height)) return false;
    if (!(near_of(camera.projection) > 0) || !(near_of(camera.projection) < far_of(camera.projection)))
        return false;
    const auto* frustum = std::get_if<Frustum>(&camera.projection);
    return frustum == nullptr || is_valid_window(*frustum);
}

bool is_valid(const Light& light) {
    const glm::vec3 place(light.position), u = light.area.edge_u, v = light.area.edge_v;
    if (light.position.w == 0 && !(glm::length(place) > 1e-6f)) return false;
    if (!(glm::length(light.spot.direction) > 1e-6f)) return false;
    const glm::dvec3 normal = glm::cross(glm::dvec3(u), glm::dvec3(v));
    if (!(glm::length(normal) > 1e-4 * glm::length(glm::dvec3(u)) * glm::length(glm::dvec3(v)))) return false;
    if (!(glm::length(u) > 1e-5f) || !(glm::length(v) > 1e-5f)) return false;
    return light.falloff.constant > 0 || light.falloff.linear > 0 || light.falloff.quadratic > 0;
}

bool is_valid(const Object& object) {
    const glm::vec3 scale = object.transform.scale;
    return std::abs(scale.x) > 1e-6f && std::abs(scale.y) > 1e-6f && std::abs(scale.z) > 1e-6f;
}

}  // namespace glint
