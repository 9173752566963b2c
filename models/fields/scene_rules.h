#pragma once
// Conditions between several numbers of a scene, which no single field can express. The reader rejects a
// scene that breaks them and the window never creates one, so that every saved scene opens again
// (docs/scene_file.md).

#include <fmt/core.h>

#include <optional>
#include <string>
#include <utility>

#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

// A violation is a Problem without a file. Its pointer is relative to the value: "/spot/direction", empty for
// the value itself.

template <class Number> [[nodiscard]] Problem out_of_range(Number number, std::string expected) {
    return {"", "", fmt::format("{} is out of range", number), std::move(expected)};
}

/// Directions count as parallel if the sine of the angle between them is below this: a float has seven
/// digits.
inline constexpr double parallel_sine = 1e-6;

/// Requires that eye and target differ, `up` is not parallel to the view direction, 0 < near < far, and the
/// frustum's window has a non-zero area.
[[nodiscard]] std::optional<Problem> violation_of(const Camera& camera);
/// Requires that direction, axis and area are not zero, and that not all falloff factors are zero.
[[nodiscard]] std::optional<Problem> violation_of(const Light& light);
/// Requires w = 0 for a directional light and w > 0 for a light with a position.
[[nodiscard]] std::optional<Problem> violation_of_w(LightKind kind, double w);
/// Requires that the position divided by its w is within the range of positions.
[[nodiscard]] std::optional<Problem> violation_of_division(const glm::dvec4& position);
/// Requires that no component of the scale is zero.
[[nodiscard]] std::optional<Problem> violation_of(const Object& object);
/// Returns the first violation of the camera, the lights and the objects, with the pointer into the scene.
[[nodiscard]] std::optional<Problem> violation_of(const Scene& scene);

/// Returns the first number outside the range of its field. For a scene it checks the scene's own numbers,
/// not its lights and objects.
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Camera& camera);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Light& light);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Object& object);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Scene& scene);

/// Returns the condition or range that keeps a scene file from representing `now`, or nothing if a file can
/// represent it. `valid` is a scene that a file can represent, so only lights and objects that differ from
/// those of `valid` are checked.
[[nodiscard]] std::optional<Problem> violation_since(const Scene& valid, const Scene& now);

/// Returns a light's homogeneous position for the renderer: unchanged if w = 0, else divided by w, so that w
/// = 1.
[[nodiscard]] glm::vec4 divided_by_w(glm::dvec4 position);

}  // namespace glint
