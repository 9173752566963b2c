#pragma once
// What is being asked: which pixel, which of its lit points, which light.

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "renderer/inspect/explain/explanation.h"
#include "ui/inspector/state.h"
#include "ui/widgets/theme.h"

namespace glint {

struct UiState;
struct PictureView;

/// The pixel to explain: with Alt held the one under the cursor, else the picked one. Nothing while neither.
[[nodiscard]] std::optional<glm::ivec2> asked_pixel(const UiState& state, const PictureView& view);

/// The lit point whose numbers are shown: the pixel's own, or the chosen corner or flat point.
[[nodiscard]] const ExplainedPoint& asked_point(const InspectorState& state, const Explanation& explanation);

/// The light whose vectors are shown: the one pointed at in the column, else the selected one, else the one
/// that adds most. Null when no light is on.
[[nodiscard]] const ExplainedLight* asked_light(const UiState& state, const ExplainedPoint& point);

// Scenes with all but one thing left out: what the picture shows while a line of the equation is pointed at.

/// One term alone: ambient, diffuse, specular or emission. Another symbol leaves the scene as it is.
[[nodiscard]] Scene with_term_alone(Scene scene, Symbol term);
/// One light alone: no other, no emission, no global ambient light.
[[nodiscard]] Scene with_light_alone(Scene scene, int light);

/// The picture shows `scene` in the next frame, with its name written over it.
void show_instead(UiState& state, const Scene& scene, const std::string& name);

}  // namespace glint
