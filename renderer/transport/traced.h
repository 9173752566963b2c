#pragma once
// Individual rays of the picture, traced again for display. World coordinates.

#include <glm/vec3.hpp>

namespace glint {

/// A shadow ray and its blocker.
struct TracedLight {
    glm::vec3 from{0}, to{0};  // `to`: the light; for a directional light, one unit away
    bool in_front = true;      // n.l > 0
    int object = -1;   // the first object hit, an index into Scene::objects; -1: the ray reaches the light
    glm::vec3 hit{0};  // where the ray hits the object
    [[nodiscard]] bool reached() const { return object < 0; }
};

/// One ray of a path, and the light added by the surface that it hits. Linear RGB.
struct PathStep {
    glm::vec3 from{0}, to{0};  // the ray; if it hits nothing, `to` is one unit away
    int object = -1;           // index into Scene::objects; -1: the ray hits nothing, and the path ends
    glm::vec3 normal{0};       // the facet's normal, on the side that the ray hits
    glm::vec3 throughput{1};   // product of k_d of the previous surfaces
    glm::vec3 emission{0};     // light emitted by the surface
    int light = -1;            // index of the chosen light in Scene::lights; -1: none
    bool reached = false;      // whether the light reaches the surface from its front
    glm::vec3 direct{0};       // reflected light from all lights, estimated from the chosen one
};

}  // namespace glint
