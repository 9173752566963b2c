// Drags of a light by its handle and by its terminator.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "renderer/reflectance/highlight.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/surface_patch.h"

namespace glint {
namespace {

using std::numbers::pi;

glm::dvec3 unit_axis(DragAlong along) {
    return {along == DragAlong::X ? 1 : 0, along == DragAlong::Y ? 1 : 0, along == DragAlong::Z ? 1 : 0};
}

glm::dvec3 dragged_direction(const LightDrag& drag, const DragView& view, glm::dvec2 cursor_px,
                             glm::dvec2 handle_px) {
    const glm::dvec3 direction = direction_of(drag.start, view.map);
    const glm::dvec2 motion = cursor_px - drag.grabbed_px;
    switch (drag.along) {
    case DragAlong::ViewPlane: {
        const Ray old_sight = ray_through(view.map, handle_px);
        const bool nearer = glm::dot(direction, old_sight.direction) <= 0;
        const glm::dvec3 at = on_dome(view.dome, ray_through(view.map, handle_px + motion), nearer);
        return glm::normalize(at - view.dome.centre);
    }
    case DragAlong::Depth: {
        const double turn = pi / view.map.size.height;
        const glm::dvec3 right(view.map.world_from_view[0]), up(view.map.world_from_view[1]);
        return rotated(rotated(direction, right, motion.y * turn), up, motion.x * turn);
    }
    case DragAlong::X:
    case DragAlong::Y:
    case DragAlong::Z: {
        const glm::dvec3 axis = to_world(drag.start, unit_axis(drag.along), 0, view.map);
        return rotated(direction, axis,
                       turn_towards(view.map, view.dome, direction, axis, handle_px + motion));
    }
    }
    return direction;  // not reached
}

Light dragged_sun(const LightDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    const ProjectedPoint handle = project(view.map, handle_of(drag.start, view.dome, view.map));
    if (!handle.in_front) return drag.start;
    const glm::dvec3 direction = dragged_direction(drag, view, cursor_px, handle.pixel);
    Light light = placed_at(drag.start, view.dome.centre + direction, view.dome, view.map);
    if (snap) light.position = glm::vec4(glm::dvec4(snapped_direction(glm::dvec3(light.position)), 0));
    return light;
}

/// Rounds the coordinates changed by the drag to multiples of the step; the others do not change.
void snap_to_grid(Light& light, const Light& start, double step) {
    for (int i = 0; i < 3; ++i)
        if (light.position[i] != start.position[i])
            light.position[i] = static_cast<float>(std::round(light.position[i] / step) * step);
}

}  // namespace

double snap_step_for(const Bounds& bounds) {
    const double size = glm::length(glm::dvec3(bounds.max) - glm::dvec3(bounds.min));
    const double wanted = std::max(size, 1e-6) / 20, power = std::pow(10, std::floor(std::log10(wanted)));
    const double digit = wanted / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

Light dragged(const LightDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    if (drag.start.kind == LightKind::Directional) return dragged_sun(drag, view, cursor_px, snap);
    const glm::dvec3 place = handle_of(drag.start, view.dome, view.map);
    const ProjectedPoint handle = project(view.map, place);
    if (!handle.in_front) return drag.start;
    const glm::dvec2 motion = cursor_px - drag.grabbed_px, wanted = handle.pixel + motion;
    glm::dvec3 moved = place;
    switch (drag.along) {
    case DragAlong::ViewPlane:
        moved = unproject(view.map, wanted, handle.depth);
        break;
    case DragAlong::Depth: {
        // A factor of e per third of the picture's height: the same relative precision near and far.
        const double factor = std::exp(std::clamp(-3 * motion.y / view.map.size.height, -7.0, 7.0));
        moved = unproject(view.map, handle.pixel, handle.depth * factor);
        break;
    }
    case DragAlong::X:
    case DragAlong::Y:
    case DragAlong::Z: {
        const glm::dvec3 axis = to_world(drag.start, unit_axis(drag.along), 0, view.map);
        moved = place + along_line(view.map, place, axis, wanted) * axis;
        break;
    }
    }
    Light light = placed_at(drag.start, moved, view.dome, view.map);
    if (snap) snap_to_grid(light, drag.start, view.snap_step);
    return light;
}

bool terminator_under(const SurfaceView& view, const Light& light, glm::dvec2 pixel, double reach) {
    const auto patch = surface_patch(view.renderer, view.map.size, pixel, 1);
    if (!patch) return false;
    const auto cosine = [&](const SeenPoint& point) {
        return cosine_at(view.scene, view.map.size, light, point);
    };
    const double steepness = patch->steepness(cosine);
    return steepness > 1e-6 && std::abs(cosine(patch->middle())) <= reach * steepness;
}

std::optional<Light> dragged_terminator(const TerminatorDrag& drag, const SurfaceView& view,
                                        glm::dvec2 pixel) {
    const auto point = seen_at(view.renderer, view.map.size, pixel);
    if (!point) return {};
    const glm::dvec3 n = in_world(view.map, point->normal, 0);
    if (drag.start.kind == LightKind::Directional) {
        const glm::dvec3 l = direction_of(drag.start, view.map), flat = l - glm::dot(l, n) * n;
        if (glm::length(flat) < 1e-3) return {};
        return placed_at(drag.start, view.dome.centre + flat, view.dome, view.map);
    }
    const glm::dvec3 p = in_world(view.map, point->position, 1);
    const glm::dvec3 from = handle_of(drag.start, view.dome, view.map), way = from - p;
    const glm::dvec3 flat = way - glm::dot(way, n) * n;
    if (glm::length(flat) < 1e-3 * glm::length(way)) return {};
    return placed_at(drag.start, p + flat, view.dome, view.map);
}

}  // namespace glint
