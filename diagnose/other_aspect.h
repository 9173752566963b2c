#pragma once
// Whether a picture shows its scene stretched: drawn at one aspect, brought at another.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "renderer/renderer.h"

namespace glint {

/// The aspect, as "16:9", at which the right scene's outlines fit the picture far better than at the
/// picture's own; nothing where none of the usual aspects fits better.
[[nodiscard]] std::optional<std::string> other_aspect(Renderer& renderer, const Scene& scene,
                                                      const Picture& wrong);

}  // namespace glint
