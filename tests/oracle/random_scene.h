#pragma once
// Scenes from a seed: the same on every machine.

#include "models/scene/scene.h"

namespace glint::oracle {

/// Scene number `number`. Any 42 consecutive scenes combine every mode (flat at the centroid and at the
/// provoking corner, facet, gouraud, phong, and gouraud under the rules of OpenGL) with every reflection
/// model; the rest (camera, objects, lights, switches) is random. Lights stay away from surfaces, and
/// exponents stay at or below 128, so that the equation is well conditioned.
[[nodiscard]] Scene random_scene(unsigned number);

/// Returns scene number `number` for fixed-function OpenGL, with up to 8 lights.
[[nodiscard]] Scene random_fixed_function_scene(unsigned number);

}  // namespace glint::oracle
