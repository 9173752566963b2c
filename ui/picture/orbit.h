#pragma once
// How a hand moves the camera: orbit, pan, dolly. Pure functions of the camera and of a motion in pixels.
// The habits are those of common 3D viewers: a turntable round `up`, a full turn over the picture's height;
// what is panned stays under the cursor; the wheel moves towards what is under the cursor.

#include <glm/vec2.hpp>
#include <optional>

#include "models/mesh/mesh.h"
#include "models/scene/camera.h"

namespace glint {

/// Turns the eye round the target: right and down are positive. `up` stays, and the eye stays 1 degree clear
/// of the poles, where up would be parallel to the view direction.
void orbit(Camera& camera, glm::dvec2 motion_px, PictureSize size);

/// Moves eye and target alike, so that what is `depth` in front of the camera follows the cursor exactly.
void pan(Camera& camera, glm::dvec2 from_px, glm::dvec2 to_px, double depth, PictureSize size);

/// Scales the way from eye and target to what shows at `cursor_px`, `depth` in front of the camera, by
/// `factor` (below 1: closer); that place stays under the cursor. Orthographic: scales the height of the
/// view. Does nothing where the camera would come closer than float can tell, or farther than 1e7.
void dolly(Camera& camera, glm::dvec2 cursor_px, double depth, double factor, PictureSize size);

/// Depth of the target in front of the camera: where pan and dolly hold on when the cursor is on the
/// background.
[[nodiscard]] double target_depth(const Camera& camera);

/// Widens near and far to hold the whole of `bounds`, if `before` held it: moving the camera must not begin
/// to cut the scene; a near plane that was set into the scene stays.
void keep_depth_range(Camera& camera, const Camera& before, const Bounds& bounds);

}  // namespace glint
