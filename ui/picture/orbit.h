#pragma once
// A hand moves the camera: orbit, pan, dolly. Pure functions of the camera and of a motion in pixels.
// The habits are those of common 3D viewers: a turntable round `up`, a full turn over the picture's height;
// what is panned stays under the cursor; the wheel moves towards what is under the cursor.

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/scene/camera.h"
#include "models/scene/scene.h"

namespace glint {

/// Turns the eye round the target: right and down are positive. `up` stays, and the eye stays 1 degree clear
/// of the poles, where up would be parallel to the view direction.
void orbit(Camera& camera, glm::dvec2 motion_px, PictureSize size);

/// Moves eye and target alike, so that what is `depth` in front of the camera follows the cursor exactly.
void pan(Camera& camera, glm::dvec2 from_px, glm::dvec2 to_px, double depth, PictureSize size);

/// Scales the way from eye and target to what shows at `cursor_px`, `depth` in front of the camera, by
/// `factor` (below 1: closer); that place stays under the cursor. Orthographic: scales the height of the
/// view. Does nothing where the camera would come closer to its target than floats can tell, or farther than
/// 1e7.
void dolly(Camera& camera, glm::dvec2 cursor_px, double depth, double factor, PictureSize size);

/// Depth of the target in front of the camera: where pan and dolly hold on when the cursor is on the
/// background.
[[nodiscard]] double target_depth(const Camera& camera);

/// Widens near and far to hold all of `bounds` if `before` held it: moving the camera must not start to cut
/// the scene off. A near plane that was set into the scene stays.
void keep_depth_range(Camera& camera, const Camera& before, const Bounds& bounds);

// The scene can be seen from the front, the side or above, in perspective or in parallel, and in views kept
// by hand. Pure functions of a camera.

/// Front looks along -z, Right along -x, Top along -y; the others from the opposite sides.
enum class ViewFrom { Front, Back, Right, Left, Top, Bottom };

/// The camera at the same distance from its target, on that side of it, y up. Above and below it stays a
/// tenth of a degree off the pole, where up would be along the view. Unchanged where `up` is not y and
/// the view would be along it.
[[nodiscard]] Camera seen_from(Camera camera, ViewFrom from);

/// Perspective and frustum become orthographic, orthographic becomes perspective; what is at the target's
/// depth keeps its size in the picture.
[[nodiscard]] Camera other_projection(Camera camera, PictureSize size);

inline constexpr std::size_t max_views = 8;

/// Keeps a view; one that is kept already is not kept twice, and the oldest of nine is forgotten.
void keep_view(std::vector<Camera>& views, const Camera& camera);

/// The view after the one that shows, from the first on again; nothing when none is kept.
[[nodiscard]] std::optional<Camera> next_view(const std::vector<Camera>& views, const Camera& shown);

}  // namespace glint
