#pragma once
// The camera's numbers.

#include "models/fields/choices.h"

namespace glint {

/// Edits the camera and says whether it did. `size` of the picture: a frustum chosen anew sees what it saw.
[[nodiscard]] bool camera_panel(Camera& camera, PictureSize size);

/// The same view through another kind of projection: what is at the target's depth keeps its size in the
/// picture.
[[nodiscard]] Projection as_projection(const Camera& camera, ProjectionKind kind, PictureSize size);

}  // namespace glint
