#pragma once
// Maps a cursor position back to a point on a line, a plane, a sphere or a circle, for all drags. All
// positions are in world coordinates.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "ui/picture/screen.h"

namespace glint {

/// Returns `v` rotated by `angle` (radians, right-handed) about the unit vector `axis`.
[[nodiscard]] glm::dvec3 rotated(glm::dvec3 v, glm::dvec3 axis, double angle);

/// Returns the smallest rotation that takes one unit vector to another; for opposite vectors, any half turn.
[[nodiscard]] glm::dmat4 rotation_between(glm::dvec3 from, glm::dvec3 to);

struct Across {
    glm::dvec3 u, v;  // unit vectors, perpendicular to a direction and to each other
};
[[nodiscard]] Across across(glm::dvec3 direction);

/// Returns the t for which `place` + t `axis` is nearest to the cursor on the screen; 0 if the line is seen
/// end-on, or if the cursor is beyond its vanishing point.
[[nodiscard]] double along_line(const ScreenMap& map, glm::dvec3 place, glm::dvec3 axis,
                                glm::dvec2 cursor_px);

/// Returns the point where the line of sight meets a sphere, on the near half or on the far half; if it
/// misses, the nearest point of the rim.
[[nodiscard]] glm::dvec3 on_dome(const Dome& dome, const Ray& ray, bool nearer);

/// Returns the point where the line of sight through the cursor meets the plane through `place` with unit
/// normal `normal`. nullopt if the plane is within 2 degrees of edge-on, or the point is behind the eye.
[[nodiscard]] std::optional<glm::dvec3> on_plane(const ScreenMap& map, glm::dvec3 place, glm::dvec3 normal,
                                                 glm::dvec2 cursor_px);

/// Returns the angle, -pi to pi, by which rotating centre + radius * `direction` about `axis` brings it
/// nearest to the cursor. `direction` and `axis` are unit vectors.
[[nodiscard]] double turn_towards(const ScreenMap& map, const Dome& circle, glm::dvec3 direction,
                                  glm::dvec3 axis, glm::dvec2 cursor_px);

/// Returns the direction with its elevation and its azimuth about y rounded to multiples of 15 degrees.
[[nodiscard]] glm::dvec3 snapped_direction(glm::dvec3 direction);

/// The view in which a drag happens. It must not change during a drag.
struct DragView {
    ScreenMap map;
    Dome dome;
    double snap_step = 0.25;  // scene units
};

}  // namespace glint
