#pragma once
// What matters to which kind of light: its place, the viewer's, the surface's angle. Lecture: "Light
// Sources", its table, by the equation of the picture.

#include "models/scene/material.h"
#include "models/scene/scene.h"

namespace glint {

/// How far a term moves, in its strongest channel, when one thing is moved; 0 when it does not move at all.
struct Moved {
    float light = 0;    // surface and viewer together, away from the light: by a tenth of its distance
    float viewer = 0;   // the viewer alone, across the line of sight: by a tenth of its distance
    float surface = 0;  // the normal turned: by one degree
    bool operator==(const Moved&) const = default;
};

struct LightNeeds {
    Moved diffuse, specular;
    float falloff = 1, spot = 1;  // at the point; of an area light, of its middle sample
};

/// How far each term moves when the light, the viewer or the surface is moved a little. The light is taken as
/// white, of intensity 1 and switched on. `place`, `normal` (unit): position and normal of the surface,
/// camera coordinates. Camera, shading and mistakes are the scene's; its own lights and objects do not count.
[[nodiscard]] LightNeeds light_needs(const Scene& scene, PictureSize size, const Light& light,
                                     const Material& material, glm::vec3 place, glm::vec3 normal);

}  // namespace glint
