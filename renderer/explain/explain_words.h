#pragma once
// What an explanation says in words, the same in the window and in text.

#include <string>

#include "models/scene/light.h"
#include "renderer/explain/explanation.h"

namespace glint {

/// The side from which the surface is seen, and where its normal points if not to the eye: "front side",
/// "back side", "back side, n turned to the eye", "front side, n points away from the eye". Precondition:
/// hit.
[[nodiscard]] std::string side_words(const Explanation& explanation);
/// Whether the pixel is what a closed surface with outward normals shows: its front side, n towards the eye.
/// Precondition: hit.
[[nodiscard]] bool is_plain_front(const Explanation& explanation);

/// The first reason why this light adds little or nothing at the point: "behind the surface: n·l < 0",
/// "outside the cone by 4.2°", "hardly reaches: falloff 0.003"; empty when it shines.
[[nodiscard]] std::string dark_reason(const ExplainedLight& explained, const Light& light);

}  // namespace glint
