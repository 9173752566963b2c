#pragma once
// Mistakes that are made in a part of the picture only (MistakeScope).

#include "models/scene/scene.h"
#include "renderer/picture.h"

namespace glint {

class Renderer;

/// Returns the scene with nothing but the lights and terms of the scope.
[[nodiscard]] Scene isolated(Scene scene, const MistakeScope& scope);

/// Draws a scene whose mistakes have a scope, with linear colours. Light is a sum: the picture is that
/// without mistakes, minus the scope's part of it, plus that part under the mistakes.
[[nodiscard]] Picture draw_scoped(Renderer& renderer, const Scene& scene, PictureSize size, int samples);

}  // namespace glint
