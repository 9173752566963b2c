#pragma once
// Rays of the picture that were followed alone, to be shown. World coordinates.

#include <glm/vec3.hpp>

namespace glint {

/// A shadow ray and what is in its way.
struct TracedLight {
    glm::vec3 from{0}, to{0};  // `to`: the light; of a directional light, one unit away
    bool in_front = true;      // n.l > 0
    int object = -1;           // that it meets first, in Scene::objects; -1: it reaches the light
    glm::vec3 hit{0};          // where it meets the object
    [[nodiscard]] bool reached() const { return object < 0; }
};

/// One ray of a path, and what the surface adds that it meets; linear RGB.
struct PathStep {
    glm::vec3 from{0}, to{0};  // the ray; without a hit, `to` is one unit away
    int object = -1;           // in Scene::objects; -1: the ray meets nothing, and the path ends
    glm::vec3 normal{0};       // of the facet, on the side that the ray meets
    glm::vec3 throughput{1};   // product of k_d of the surfaces before
    glm::vec3 emission{0};     // of the surface
    int light = -1;            // chosen light, in Scene::lights; -1: there is none
    bool reached = false;      // the light reaches the surface from its front
    glm::vec3 direct{0};       // light of all lights that it reflects, estimated from the chosen one
};

}  // namespace glint
