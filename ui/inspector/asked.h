#pragma once
// What is being asked: which pixel, which of its lit points, which light.

#include <glm/vec2.hpp>
#include <optional>

#include "renderer/inspect/explain/explanation.h"
#include "ui/inspector/state.h"

namespace glint {

struct UiState;
struct PictureView;

/// The pixel to explain: with Alt held the one under the cursor, else the picked one. Nothing while neither.
[[nodiscard]] std::optional<glm::ivec2> asked_pixel(const UiState& state, const PictureView& view);

/// The lit point whose numbers are shown: the pixel's own, or the chosen corner or flat point.
[[nodiscard]] const ExplainedPoint& asked_point(const WhyState& state, const Explanation& why);

/// The light whose vectors are shown: the one pointed at in the column, else the selected one, else the one
/// that adds most. Null when no light is on.
[[nodiscard]] const ExplainedLight* asked_light(const UiState& state, const ExplainedPoint& point);

}  // namespace glint
