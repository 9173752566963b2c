#pragma once
// Scenes with all but one thing left out: what the picture shows while a line of the equation is pointed at.

#include <string>

#include "models/scene/scene.h"
#include "ui/widgets/theme.h"

namespace glint {

/// One term alone: ambient, diffuse, specular or emission. Another symbol leaves the scene as it is.
[[nodiscard]] Scene with_term_alone(Scene scene, Symbol term);
/// One light alone: no other, no emission, no global ambient light.
[[nodiscard]] Scene with_light_alone(Scene scene, int light);

struct UiState;

/// The picture shows `scene` in the next frame, with its name written over it.
void show_instead(UiState& state, const Scene& scene, const std::string& name);

}  // namespace glint
