#pragma once
// The way from the world to the pixels of a picture and back, for one camera and one size. Handles, the probe
// and the drags are computed with it, so that they agree with what the renderer drew. Pixels: x right, y
// down, the first row at the top; pixel (x, y) has its centre at (x + 1/2, y + 1/2).

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "models/scene/camera.h"

namespace glint {

struct ScreenMap {
    glm::dmat4 view_from_world{1}, world_from_view{1}, clip_from_view{1}, clip_from_world{1};
    PictureSize size;
};

[[nodiscard]] ScreenMap screen_map(const Camera& camera, PictureSize size);

struct OnScreen {
    glm::dvec2 pixel{0};
    double depth = 0;       // in front of the camera, scene units: -z in camera coordinates
    bool in_front = false;  // false: at or behind the eye; then `pixel` says nothing
};

/// Where a place in the world shows. It may be outside the picture.
[[nodiscard]] OnScreen project(const ScreenMap& map, glm::dvec3 world);

/// The place in the world that shows at `pixel`, `depth` in front of the camera. Inverse of project().
[[nodiscard]] glm::dvec3 unproject(const ScreenMap& map, glm::dvec2 pixel, double depth);

struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1};  // world coordinates, direction unit
};

/// The line of sight through a pixel: from the eye, or (orthographic) from the plane of the eye.
[[nodiscard]] Ray ray_through(const ScreenMap& map, glm::dvec2 pixel);

}  // namespace glint
