#pragma once
// Finds the position of a light in the world, and how its numbers change when it is moved there or given in
// other coordinates. A directional light has no position; it is shown on a dome round the scene.

#include <glm/vec3.hpp>

#include "models/scene/scene.h"
#include "ui/picture/screen.h"

namespace glint {

/// A box round all objects that are shown, in world coordinates; a cube of edge 2 at the target when there
/// are none.
[[nodiscard]] Bounds scene_bounds(const Scene& scene);

/// A dome round what the camera looks at, sized to stay inside the view, so that every directional light has
/// a handle in sight; not larger than twice the scene.
[[nodiscard]] Dome sun_dome(glm::vec3 target, const Bounds& bounds, const ScreenMap& map);

/// Where the light's handle is: its place, or (directional) its place on the dome. World coordinates.
[[nodiscard]] glm::dvec3 handle_of(const Light& light, const Dome& dome, const ScreenMap& map);

/// Unit direction from world coordinates to where the handle is, seen from the dome's centre.
[[nodiscard]] glm::dvec3 direction_of(const Light& light, const ScreenMap& map);

/// The light with its handle at `place` in the world (directional: turned towards it; unchanged for the
/// centre).
[[nodiscard]] Light placed_at(Light light, glm::dvec3 place, const Dome& dome, const ScreenMap& map);

/// Takes a vector (w = 0) or position (w = 1) from the light's own coordinates to the world.
[[nodiscard]] glm::dvec3 to_world(const Light& light, glm::dvec3 own, double w, const ScreenMap& map);

/// The inverse of to_world().
[[nodiscard]] glm::dvec3 to_own(const Light& light, glm::dvec3 world, double w, const ScreenMap& map);

/// A spot's axis or a panel's edges, turned by a rotation of the world.
void turn_shape(Light& light, const glm::dmat4& turn, const ScreenMap& map);

/// Counts the light in other coordinates: it stays where it is at this moment, shape and axis too.
[[nodiscard]] Light in_space(Light light, LightSpace space, const Camera& camera);

/// Gives the light another kind: a place becomes the direction from the dome's centre, and back.
[[nodiscard]] Light as_kind(Light light, LightKind kind, const Dome& dome, const ScreenMap& map);

}  // namespace glint
