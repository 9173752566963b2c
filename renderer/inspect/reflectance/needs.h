#pragma once
// Which term of the equation needs the normal, the light's direction and the viewer. Lecture: "Lighting
// Review".

#include <array>
#include <glm/vec3.hpp>

#include "renderer/inspect/reflectance/lobes.h"

namespace glint {

/// How far a term moves, in its strongest channel, when one vector is turned by a degree (the larger of two
/// ways across it); 0 when it does not move at all.
struct Needs {
    float normal = 0, light = 0, viewer = 0;
};

/// Ambient, diffuse and specular, in this order. n, l, v unit, in one frame; the light is white.
[[nodiscard]] std::array<Needs, 3> term_needs(const Reflector& reflector, glm::vec3 n, glm::vec3 l,
                                              glm::vec3 v);

}  // namespace glint
