#pragma once
// WHY: the lighting equation at the picked pixel, with its numbers. Everything shown is read from the
// renderer's own explanation, so that it sums to the pixel.

#include "models/scene.h"
#include "renderer/inspect/explanation.h"

namespace glint {

struct InspectorState {
    int corner = 0;  // whose numbers are listed under Gouraud and flat
};

/// What the user did in the inspector.
struct InspectorWishes {
    bool forget = false;  // close the probe
    int select_object = -1;
    int select_light = -1;
};

/// Draws the explanation, or (null) how to ask for one. Edits nothing of the scene.
[[nodiscard]] InspectorWishes inspector(InspectorState& state, const Explanation* why, const Scene& scene);

}  // namespace glint
