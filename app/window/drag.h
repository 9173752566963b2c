#pragma once
// A hand that drags something, frame by frame: what benchmarks move.

#include "models/scene/scene.h"

namespace glint {

enum class Drag { Light, Material, Camera, Object };

/// Puts into `scene` what a hand has dragged of `start` by `frame`; every frame differs from the one before.
/// The first light or object is dragged, on a circle. Precondition: there is one.
void drag_to(Scene& scene, const Scene& start, Drag drag, int frame);

}  // namespace glint
