#pragma once
// Measures which term of the equation needs the normal, the light's direction and the viewer. Lecture:
// "Lighting Review".

#include <array>
#include <glm/vec3.hpp>

#include "models/scene/material.h"
#include "models/scene/scene.h"
#include "renderer/reflectance/lobes.h"

namespace glint {

/// How far a term moves, in its strongest channel, when one vector is turned by a degree (the larger of two
/// ways across it); 0 when it does not move at all.
struct TermSensitivity {
    float normal = 0, light = 0, viewer = 0;
};

/// Ambient, diffuse and specular, in this order. n, l, v unit, in one frame; the light is white.
[[nodiscard]] std::array<TermSensitivity, 3> term_sensitivity(const Reflector& reflector, glm::vec3 n,
                                                              glm::vec3 l, glm::vec3 v);

// What matters to which kind of light: its place, the viewer's, the surface's angle. Lecture: "Light
// Sources", its table, by the equation of the picture.

/// How far a term moves, in its strongest channel, when one thing is moved; 0 when it does not move at all.
struct Moved {
    float light = 0;    // surface and viewer together, away from the light: by a tenth of its distance
    float viewer = 0;   // the viewer alone, across the line of sight: by a tenth of its distance
    float surface = 0;  // the normal turned: by one degree
    bool operator==(const Moved&) const = default;
};

struct LightSensitivity {
    Moved diffuse, specular;
    float falloff = 1, spot = 1;  // at the point; of an area light, of its middle sample
};

/// How far each term moves when the light, the viewer or the surface is moved a little. The light is taken as
/// white, of intensity 1 and switched on. `place`, `normal` (unit): position and normal of the surface,
/// camera coordinates. Camera, shading and mistakes are the scene's; its own lights and objects do not count.
[[nodiscard]] LightSensitivity light_sensitivity(const Scene& scene, PictureSize size, const Light& light,
                                                 const Material& material, glm::vec3 place, glm::vec3 normal);

}  // namespace glint
