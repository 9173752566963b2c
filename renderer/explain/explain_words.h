#pragma once
// Phrases of an explanation, shared by the window and the text output.

#include <string>

#include "models/scene/light.h"
#include "renderer/explain/explanation.h"

namespace glint {

/// The visible side of the surface, with the direction of the normal if it does not point towards the eye:
/// "front side", "back side", "back side, n turned to the eye", "front side, n points away from the eye".
/// Precondition: hit.
[[nodiscard]] std::string side_words(const Explanation& explanation);
/// Whether the pixel looks as expected on a closed surface with outward normals: front side, n towards the
/// eye. Precondition: hit.
[[nodiscard]] bool is_plain_front(const Explanation& explanation);

/// "64 samples" of an area light; "4 of 64 samples so far" while the picture is being refined.
[[nodiscard]] std::string sample_count(const ExplainedLight& explained, const Light& area);

/// The rounding error of n·l for a light in the plane of a face: up to it, n·l counts as 0.
inline constexpr float grazing_cosine = 1e-5f;

/// The main reason why this light contributes little or nothing at the point: "behind the surface: n·l < 0",
/// "in the shadow of Cube", "outside the cone by 4.2°", "hardly reaches: falloff 0.003". Empty if the light
/// reaches the point.
[[nodiscard]] std::string dark_reason(const ExplainedLight& explained, const Light& light);

}  // namespace glint
