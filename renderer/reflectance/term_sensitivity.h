#pragma once
// Measures which terms of the equation depend on the normal, the light's direction and the viewer. Lecture:
// "Lighting Review".

#include <array>
#include <glm/vec3.hpp>

#include "models/scene/material.h"
#include "models/scene/scene.h"
#include "renderer/reflectance/lobes.h"

namespace glint {

/// The change of a term, in its strongest channel, when one vector is rotated by a degree (the larger of two
/// perpendicular rotations); 0 if it does not change at all.
struct TermSensitivity {
    float normal = 0, light = 0, viewer = 0;
};

/// Ambient, diffuse and specular, in this order. n, l, v unit, in one frame; the light is white.
[[nodiscard]] std::array<TermSensitivity, 3> term_sensitivity(const Reflector& reflector, glm::vec3 n,
                                                              glm::vec3 l, glm::vec3 v);

// The dependence of a kind of light on its position, the viewer's position and the surface's angle. Lecture:
// the table of "Light Sources", measured with the picture's equation.

/// The change of a term, in its strongest channel, when one thing is moved; 0 if it does not change at all.
struct Moved {
    float light = 0;    // surface and viewer together, away from the light: by a tenth of its distance
    float viewer = 0;   // the viewer alone, across the line of sight: by a tenth of its distance
    float surface = 0;  // the normal: rotated by one degree
    bool operator==(const Moved&) const = default;
};

struct LightSensitivity {
    Moved diffuse, specular;
    float falloff = 1, spot = 1;  // at the point; for an area light, of its middle sample
};

/// The change of each term when the light, the viewer or the surface is moved slightly. The light is treated
/// as white, of intensity 1 and switched on. `place`, `normal` (unit): position and normal of the surface,
/// camera coordinates. Camera, shading and mistakes are the scene's; its lights and objects are ignored.
[[nodiscard]] LightSensitivity light_sensitivity(const Scene& scene, PictureSize size, const Light& light,
                                                 const Material& material, glm::vec3 place, glm::vec3 normal);

}  // namespace glint
