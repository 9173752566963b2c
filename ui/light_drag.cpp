#include "ui/light_drag.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec4.hpp>
#include <numbers>

namespace glint {
namespace {

constexpr double pi = std::numbers::pi;

glm::dvec3 unit_axis(DragAlong along) {
    return {along == DragAlong::X ? 1 : 0, along == DragAlong::Y ? 1 : 0, along == DragAlong::Z ? 1 : 0};
}

glm::dvec3 rotated(glm::dvec3 v, glm::dvec3 axis, double angle) {
    return glm::dvec3(glm::rotate(glm::dmat4(1), angle, axis) * glm::dvec4(v, 0));
}

/// Where on the line `place` + t `axis` the cursor is nearest to on the screen. On the screen the line is
/// p(t) = (A + t B)/(a + t b) with clip coordinates A, a of the place and B, b of the axis; the foot of the
/// cursor on it is known, and one coordinate of p(t) = foot gives t.
double along_line(const ScreenMap& map, glm::dvec3 place, glm::dvec3 axis, glm::dvec2 cursor_px) {
    const glm::dvec4 at = map.clip_from_world * glm::dvec4(place, 1),
                     step = map.clip_from_world * glm::dvec4(axis, 0);
    const glm::dvec2 half{map.size.width / 2.0, map.size.height / 2.0};
    const auto pixel = [&](glm::dvec2 ndc) { return glm::dvec2((ndc.x + 1) * half.x, (1 - ndc.y) * half.y); };
    const glm::dvec2 from = pixel(glm::dvec2(at) / at.w);
    // Direction of the line on the screen: the derivative of p at t = 0.
    const glm::dvec2 slope = (glm::dvec2(step) * at.w - glm::dvec2(at) * step.w) / (at.w * at.w);
    const glm::dvec2 way{slope.x * half.x, -slope.y * half.y};
    const double length = glm::length(way);
    if (length < 1e-6) return 0;  // seen end on
    const glm::dvec2 foot = from + glm::dot(cursor_px - from, way) / (length * length) * way;
    const glm::dvec2 ndc{foot.x / half.x - 1, 1 - foot.y / half.y};
    const bool by_x = std::abs(way.x) > std::abs(way.y);
    const double value = by_x ? ndc.x : ndc.y, a = by_x ? at.x : at.y, b = by_x ? step.x : step.y;
    const double below = value * step.w - b;
    const double t = std::abs(below) < 1e-12 ? 0 : (a - value * at.w) / below;
    // Beyond the vanishing point the line has no place in front of the eye.
    return at.w + t * step.w > 1e-3 * at.w ? t : 0;
}

/// Where the line of sight meets the dome, on the half nearer to the eye or the one behind; past the rim, the
/// rim.
glm::dvec3 on_dome(const Dome& dome, const Ray& ray, bool nearer) {
    const glm::dvec3 to_centre = dome.centre - ray.origin;
    const double along = glm::dot(to_centre, ray.direction);
    const glm::dvec3 foot = ray.origin + along * ray.direction;
    const double off = glm::length(foot - dome.centre);
    if (off >= dome.radius) return dome.centre + dome.radius / off * (foot - dome.centre);
    const double half_chord = std::sqrt(dome.radius * dome.radius - off * off);
    return foot + (nearer ? -half_chord : half_chord) * ray.direction;
}

/// The turn round `axis` that brings a handle on the dome nearest to the cursor: the best of 360, then
/// refined.
double turn_towards(const DragView& view, glm::dvec3 direction, glm::dvec3 axis, glm::dvec2 cursor_px) {
    const auto distance = [&](double angle) {
        const OnScreen at =
            project(view.map, view.dome.centre + view.dome.radius * rotated(direction, axis, angle));
        // A small price on large turns keeps the handle from jumping to the far side of its circle.
        return (at.in_front ? glm::length(at.pixel - cursor_px) : 1e9) + std::abs(angle);
    };
    double best = 0;
    for (int i = -180; i < 180; ++i)
        if (distance(i * pi / 180) < distance(best)) best = i * pi / 180;
    for (double step = pi / 360; step > 1e-7; step /= 2)
        for (const double trial : {best - step, best + step})
            if (distance(trial) < distance(best)) best = trial;
    return best;
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
        return rotated(direction, axis, turn_towards(view, direction, axis, handle_px + motion));
    }
    }
    return direction;  // not reached
}

/// A direction with its height above and its angle round y at multiples of 15 degrees.
glm::vec4 snapped_direction(glm::vec4 p) {
    const double step = pi / 12;
    const double height = std::round(std::asin(std::clamp(double(p.y), -1.0, 1.0)) / step) * step;
    const double round_y = std::round(std::atan2(double(p.x), double(p.z)) / step) * step;
    return glm::vec4(glm::dvec4(std::cos(height) * std::sin(round_y), std::sin(height),
                                std::cos(height) * std::cos(round_y), 0));
}

Light dragged_sun(const LightDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    const OnScreen handle = project(view.map, handle_of(drag.start, view.dome, view.map));
    if (!handle.in_front) return drag.start;
    const glm::dvec3 direction = dragged_direction(drag, view, cursor_px, handle.pixel);
    Light light = placed_at(drag.start, view.dome.centre + direction, view.dome, view.map);
    if (snap) light.position = snapped_direction(light.position);
    return light;
}

/// Coordinates that the drag moved, to multiples of the step; the others stay as they are.
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
    const OnScreen handle = project(view.map, place);
    if (!handle.in_front) return drag.start;
    const glm::dvec2 motion = cursor_px - drag.grabbed_px, wanted = handle.pixel + motion;
    glm::dvec3 moved = place;
    switch (drag.along) {
    case DragAlong::ViewPlane:
        moved = unproject(view.map, wanted, handle.depth);
        break;
    case DragAlong::Depth: {
        // A third of the picture's height is a factor e: as fine near the eye as far from it.
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

}  // namespace glint
