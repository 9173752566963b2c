#pragma once
// Mistakes that are made only in a part of the picture (MistakeScope).

#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/picture.h"

namespace glint {

class Renderer;

/// Whether the scene's mistakes are made only in a part of the picture. Visibility has no scope: with
/// culled_by_light, all mistakes are made everywhere.
[[nodiscard]] bool has_scope(const Scene& scene);

/// Returns the scene with nothing but the lights and terms of the scope.
[[nodiscard]] Scene isolated(Scene scene, const MistakeScope& scope);

/// Draws a scene whose mistakes have a scope, with linear colours. Light is a sum: the picture is the one
/// without mistakes, minus the scope's part of it, plus that part with the mistakes.
[[nodiscard]] Picture draw_scoped(Renderer& renderer, const Scene& scene, PictureSize size, int samples);

/// Explains a pixel of that picture: the lights and terms of the scope are those with the mistakes. Its sum
/// equals the pixel to the last bit. Preconditions as for Renderer::explain_as(), for the scene with and
/// without the mistakes.
[[nodiscard]] Explanation explain_scoped(const Renderer& renderer, const Scene& scene, int x, int y);

}  // namespace glint
