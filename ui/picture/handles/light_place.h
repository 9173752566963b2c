#pragma once
// Computes a light's position in the world, and its numbers after a move there or a change of coordinates. A
// directional light has no position; it is shown on a dome round the scene.

#include <glm/vec3.hpp>

#include "models/scene/scene.h"
#include "ui/picture/screen.h"

namespace glint {

/// A box round all visible objects, in world coordinates; a cube of edge 2 at the target if there are none.
[[nodiscard]] Bounds scene_bounds(const Scene& scene);

/// The height of the widest horizontal object, such as a floor; without one, the lowest height of the scene.
[[nodiscard]] double ground_height(const Scene& scene);

/// A dome round the camera's target, sized to stay inside the view, so that every directional light has a
/// visible handle; at most twice the scene.
[[nodiscard]] Dome sun_dome(glm::vec3 target, const Bounds& bounds, const ScreenMap& map);

/// The position of the light's handle: the light's own, or (directional) the one on the dome. World
/// coordinates.
[[nodiscard]] glm::dvec3 handle_of(const Light& light, const Dome& dome, const ScreenMap& map);

/// Unit direction from the dome's centre to the handle, world coordinates.
[[nodiscard]] glm::dvec3 direction_of(const Light& light, const ScreenMap& map);

/// The light with its handle at `place` in the world (directional: turned towards it; unchanged at the
/// centre).
[[nodiscard]] Light placed_at(Light light, glm::dvec3 place, const Dome& dome, const ScreenMap& map);

/// Converts a vector (w = 0) or position (w = 1) from the light's own coordinates to the world.
[[nodiscard]] glm::dvec3 to_world(const Light& light, glm::dvec3 own, double w, const ScreenMap& map);

/// The inverse of to_world().
[[nodiscard]] glm::dvec3 to_own(const Light& light, glm::dvec3 world, double w, const ScreenMap& map);

/// Turns a spot's axis or a panel's edges by a rotation of the world.
void turn_shape(Light& light, const glm::dmat4& turn, const ScreenMap& map);

/// Expresses the light in other coordinates; its current position, shape and axis do not change.
[[nodiscard]] Light in_space(Light light, LightSpace space, const Camera& camera);

/// Changes the light's kind: a position becomes the direction from the dome's centre, and back.
[[nodiscard]] Light as_kind(Light light, LightKind kind, const Dome& dome, const ScreenMap& map);

}  // namespace glint
