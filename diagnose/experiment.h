#pragma once
// Finds a change of a scene that tells apart mistakes that look alike in it.

#include <optional>
#include <vector>

#include "diagnose/diagnose.h"

namespace glint {

/// The small change of the camera, of a light or of a material under which the pictures of the given mistakes
/// differ most from each other; nothing for fewer than two, or where no change that is tried parts them by
/// more than a few levels. Throws LoadCancelled when this thread's load shall end (models/progress.h).
[[nodiscard]] std::optional<Experiment> find_experiment(const SceneDocument& document, PictureSize size,
                                                        const std::vector<MistakeSet>& mistakes, int threads);

}  // namespace glint
