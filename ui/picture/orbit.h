#pragma once
// Moves the camera with the mouse: orbit, pan, dolly. Pure functions of the camera and a motion in pixels.
// The conventions are those of common 3D viewers: a turntable about `up`, a full turn per picture height; a
// panned point stays under the cursor; the wheel moves towards the point under the cursor.

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/scene/scene.h"

namespace glint {

/// Turns the eye around the target: right and down are positive. `up` does not change, and the eye stays 1
/// degree away from the poles, where up would be parallel to the viewing direction.
void orbit(Camera& camera, glm::dvec2 motion_px, PictureSize size);

/// Moves the eye and the target together, so that a point `depth` in front of the camera follows the cursor
/// exactly.
void pan(Camera& camera, glm::dvec2 from_px, glm::dvec2 to_px, double depth, PictureSize size);

/// Scales the distances of the eye and the target from the point at `cursor_px`, `depth` in front of the
/// camera, by `factor` (below 1: closer); that point stays under the cursor. Orthographic: scales the height
/// of the view. Does nothing if the camera would be closer to its target than floats can resolve, or farther
/// than 1e7.
void dolly(Camera& camera, glm::dvec2 cursor_px, double depth, double factor, PictureSize size);

/// Moves the camera along its viewing direction and sideways until the visible objects, or the one with that
/// index, fill 80 % of a picture of that size in width or height.
void fill_picture(Scene& scene, int object, PictureSize size);

/// Returns the depth of the target in front of the camera, which pan and dolly use when the cursor is on the
/// background.
[[nodiscard]] double target_depth(const Camera& camera);

/// Moves the near and far planes apart to contain all of `bounds` if those of `before` did, so that moving
/// the camera never starts to clip the scene. A near plane that already cuts the scene does not change.
void keep_depth_range(Camera& camera, const Camera& before, const Bounds& bounds);

// Views of the scene from the front, the side or above, in perspective or parallel projection, and saved
// views. Pure functions of a camera.

/// Front looks along -z, Right along -x, Top along -y; the others look from the opposite sides.
enum class ViewFrom { Front, Back, Right, Left, Top, Bottom };

/// Returns the camera moved to that side of its target, at the same distance, with y up. From above and
/// below, it stays a tenth of a degree off the pole, where up would be parallel to the viewing direction.
/// Returns the camera unchanged if `up` is not y and would be parallel to the viewing direction.
[[nodiscard]] Camera seen_from(Camera camera, ViewFrom from);

/// Switches perspective and frustum to orthographic, and orthographic to perspective. Objects at the target's
/// depth keep their size in the picture.
[[nodiscard]] Camera other_projection(Camera camera, PictureSize size);

inline constexpr std::size_t max_views = 8;

/// Saves a view. A view that is already saved is not added again, and beyond nine the oldest is dropped.
void keep_view(std::vector<Camera>& views, const Camera& camera);

/// Returns the saved view after the current one, cyclically; nullopt if there are no saved views.
[[nodiscard]] std::optional<Camera> next_view(const std::vector<Camera>& views, const Camera& shown);

}  // namespace glint
