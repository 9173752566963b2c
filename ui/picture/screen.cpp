#include "ui/picture/screen.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "renderer/geometry/clip.h"

namespace glint {
namespace {

Viewport viewport_of(const ScreenMap& map) {
    return {static_cast<double>(map.size.width), static_cast<double>(map.size.height),
            map.clip_from_view[2][3] == 0};
}

}  // namespace

ScreenMap screen_map(const Camera& camera, PictureSize size) {
    ScreenMap map;
    map.view_from_world = view_from_world(camera);
    map.world_from_view = world_from_view(camera);
    map.clip_from_view = clip_from_view(camera.projection, size);
    map.clip_from_world = map.clip_from_view * map.view_from_world;
    map.size = size;
    return map;
}

OnScreen project(const ScreenMap& map, glm::dvec3 world) {
    const glm::dvec4 view = map.view_from_world * glm::dvec4(world, 1);
    const glm::dvec4 clip = map.clip_from_view * view;
    if (!(clip.w > 1e-9)) return {{}, -view.z, false};
    return {to_pixel(viewport_of(map), clip), -view.z, true};
}

glm::dvec3 unproject(const ScreenMap& map, glm::dvec2 pixel, double depth) {
    const glm::dvec2 ndc = to_ndc(viewport_of(map), pixel);
    const glm::dmat4& m = map.clip_from_view;  // m[column][row]
    const double z = -depth, w = m[2][3] * z + m[3][3];
    const double x = (ndc.x * w - m[2][0] * z - m[3][0]) / m[0][0];
    const double y = (ndc.y * w - m[2][1] * z - m[3][1]) / m[1][1];
    return glm::dvec3(map.world_from_view * glm::dvec4(x, y, z, 1));
}

Ray ray_through(const ScreenMap& map, glm::dvec2 pixel) {
    // A projection with a constant w (orthographic) sees along parallel lines.
    const bool parallel = map.clip_from_view[2][3] == 0;
    const glm::dvec3 origin = parallel ? unproject(map, pixel, 0) : glm::dvec3(map.world_from_view[3]);
    return {origin, glm::normalize(unproject(map, pixel, 1) - origin)};
}

}  // namespace glint
