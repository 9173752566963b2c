#pragma once
// Texts about the numbers in an explanation, such as what was clipped. All functions are pure.

#include <string>

#include "renderer/explain/explain.h"
#include "ui/document/scene_edit.h"

namespace glint {

/// Describes an area light's samples: "36 samples, n·l −0.12 to 0.71".
[[nodiscard]] std::string sample_words(const ExplainedLight& area, const Light& light);

/// Names the channels that exceed 1 after exposure: "clips: R 1.31 → 1"; empty if none does.
[[nodiscard]] std::string clipping_reason(glm::vec3 sum, float exposure);

/// The terms in the sum at one point; for corners and flat points, after weighting.
struct TermSums {
    glm::vec3 emission{0}, ambient{0}, diffuse{0}, specular{0};
    glm::vec3 tone{0};     // cool to warm: replaces emission, ambient and diffuse
    glm::vec3 bounced{0};  // replaces global ambient light
};
[[nodiscard]] TermSums term_sums(const Explanation& explanation);

/// The angle (degrees, 0 to 180) of a cosine; clamps cosines that rounding has pushed past 1.
[[nodiscard]] double angle_deg(float cosine);

/// Formats a number in a column: three decimals, fewer for large numbers, more for small ones until two
/// significant digits show. A magnitude below one millionth becomes 0, without a sign.
[[nodiscard]] std::string shown_number(float value);
[[nodiscard]] std::string shown_vector(glm::vec3 v);

// A label for a JSON pointer into the scene file, and the panel that contains its number.

struct NamedNumber {
    std::string owner;  // "Bulb", "Teapot", "Camera"
    std::string what;   // "position x", "diffuse red", "falloff quadratic"; empty for the entire owner
    Selection selection;
};

/// The item that a pointer refers to or into: NamedNumber::owner.
[[nodiscard]] std::string owner_of(const std::string& pointer, const Scene& scene);
/// Names a number of this scene, or an entire object. An invalid pointer keeps its own text.
[[nodiscard]] NamedNumber named_number(const std::string& pointer, const Scene& scene);

}  // namespace glint
