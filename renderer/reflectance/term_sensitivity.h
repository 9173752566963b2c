#pragma once
// Measures which terms of the equation depend on the normal, the light direction and the viewer. Lecture:
// "Lighting Review".

#include <array>
#include <glm/vec3.hpp>

#include "models/scene/scene.h"
#include "renderer/reflectance/lobes.h"

namespace glint {

/// The change of a term, in the channel that changes most, when one vector is rotated by one degree (the
/// larger of two perpendicular rotations). 0 if the term does not change at all.
struct TermSensitivity {
    float normal = 0, light = 0, viewer = 0;
};

/// Ambient, diffuse and specular, in this order. n, l, v: unit vectors in the same frame. The light is white.
[[nodiscard]] std::array<TermSensitivity, 3> term_sensitivity(const Reflector& reflector, glm::vec3 n,
                                                              glm::vec3 l, glm::vec3 v);

// How the effect of a type of light depends on its position, the viewer's position and the orientation of the
// surface. Lecture: the table of "Light Sources", measured with the picture's equation.

/// The change of a term, in the channel that changes most, due to one movement; 0 if it does not change at
/// all.
struct Moved {
    float light = 0;    // surface and viewer move away from the light together, by a tenth of its distance
    float viewer = 0;   // the viewer moves perpendicular to the line of sight, by a tenth of its distance
    float surface = 0;  // the normal rotates by one degree
    bool operator==(const Moved&) const = default;
};

struct LightSensitivity {
    Moved diffuse, specular;
    float falloff = 1, spot = 1;  // at the point; for an area light, of its middle sample
};

/// The change of each term when the light, the viewer or the surface is moved slightly. Treats the light as
/// white, of intensity 1 and enabled. `place`, `normal`: position and unit normal of the surface, camera
/// coordinates. Uses the scene's camera, shading and mistakes; ignores its lights and objects.
[[nodiscard]] LightSensitivity light_sensitivity(const Scene& scene, PictureSize size, const Light& light,
                                                 const Material& material, glm::vec3 place, glm::vec3 normal);

}  // namespace glint
