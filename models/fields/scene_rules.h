#pragma once
// Conditions between the numbers of a scene, which no single field can hold. The reader refuses a scene that
// breaks them and the window lets no scene break them, so that every saved scene opens again
// (docs/scene_file.md).

#include <fmt/core.h>

#include <optional>
#include <string>
#include <utility>

#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

// A violation is a Problem without a file; its pointer is below the value: "/spot/direction", empty for the
// value itself.

template <class Number> [[nodiscard]] Problem out_of_range(Number number, std::string expected) {
    return {"", "", fmt::format("{} is out of range", number), std::move(expected)};
}

/// Directions whose sine of the angle between them is below this count as parallel: a float keeps seven
/// digits.
inline constexpr double parallel_sine = 1e-6;

/// Requires the eye apart from the target, `up` not along the view, 0 < near < far, and a frustum with area.
[[nodiscard]] std::optional<Problem> violation_of(const Camera& camera);
/// Requires a direction, an axis and an area that are not zero, and a falloff that is not all zero.
[[nodiscard]] std::optional<Problem> violation_of(const Light& light);
/// Requires w = 0 for a directional light and w > 0 for a light with a position.
[[nodiscard]] std::optional<Problem> violation_of_w(LightKind kind, double w);
/// Requires that the position divided by its w is within what a position may be.
[[nodiscard]] std::optional<Problem> violation_of_division(const glm::dvec4& position);
/// Requires a scale without a zero.
[[nodiscard]] std::optional<Problem> violation_of(const Object& object);
/// Returns the first violation of its camera, its lights and its objects, with the pointer into the scene.
[[nodiscard]] std::optional<Problem> violation_of(const Scene& scene);

/// Returns the first number that is not within the range of its field; of a scene one of its own, not of its
/// lights and objects.
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Camera& camera);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Light& light);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Object& object);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Scene& scene);

/// Returns why a scene file could not hold `now`: a condition or a range that is not met; nothing if it
/// could. `valid` is a scene that a file can hold. So lights and objects are checked only if they differ from
/// those of `valid`.
[[nodiscard]] std::optional<Problem> violation_since(const Scene& valid, const Scene& now);

/// Returns a light's homogeneous position as the renderer wants it: unchanged if w = 0, else divided by w, so
/// that w = 1.
[[nodiscard]] glm::vec4 divided_by_w(glm::dvec4 position);

}  // namespace glint
