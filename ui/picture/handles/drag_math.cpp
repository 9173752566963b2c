#include "ui/picture/handles/drag_math.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec4.hpp>
#include <numbers>

namespace glint {

using std::numbers::pi;

glm::dvec3 rotated(glm::dvec3 v, glm::dvec3 axis, double angle) {
    return glm::dvec3(glm::rotate(glm::dmat4(1), angle, axis) * glm::dvec4(v, 0));
}

// On the screen the line is p(t) = (A + t B)/(a + t b) with clip coordinates A, a of the position and B, b of
// the axis. The cursor's projection onto that line is known; setting one coordinate of p(t) equal to it gives
// t.
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
    if (length < 1e-6) return 0;  // seen end-on
    const glm::dvec2 foot = from + glm::dot(cursor_px - from, way) / (length * length) * way;
    const glm::dvec2 ndc{foot.x / half.x - 1, 1 - foot.y / half.y};
    const bool by_x = std::abs(way.x) > std::abs(way.y);
    const double value = by_x ? ndc.x : ndc.y, a = by_x ? at.x : at.y, b = by_x ? step.x : step.y;
    const double below = value * step.w - b;
    const double t = std::abs(below) < 1e-12 ? 0 : (a - value * at.w) / below;
    // Beyond the vanishing point, no point of the line is in front of the eye.
    return at.w + t * step.w > 1e-3 * at.w ? t : 0;
}

glm::dvec3 on_dome(const Dome& dome, const Ray& ray, bool nearer) {
    const glm::dvec3 to_centre = dome.centre - ray.origin;
    const double along = glm::dot(to_centre, ray.direction);
    const glm::dvec3 foot = ray.origin + along * ray.direction;
    const double off = glm::length(foot - dome.centre);
    if (off >= dome.radius) return dome.centre + dome.radius / off * (foot - dome.centre);
    const double half_chord = std::sqrt(dome.radius * dome.radius - off * off);
    return foot + (nearer ? -half_chord : half_chord) * ray.direction;
}

// Tries 360 angles, then refines the best one.
double turn_towards(const ScreenMap& map, const Dome& circle, glm::dvec3 direction, glm::dvec3 axis,
                    glm::dvec2 cursor_px) {
    const auto distance = [&](double angle) {
        const ProjectedPoint at =
            project(map, circle.centre + circle.radius * rotated(direction, axis, angle));
        // A small penalty on large turns keeps the handle from jumping to the far side of its circle.
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

glm::dmat4 rotation_between(glm::dvec3 from, glm::dvec3 to) {
    const double cosine = std::clamp(glm::dot(from, to), -1.0, 1.0);
    glm::dvec3 axis = glm::cross(from, to);
    if (glm::length(axis) < 1e-12) {
        if (cosine > 0) return glm::dmat4(1);
        axis = across(from).u;
    }
    return glm::rotate(glm::dmat4(1), std::acos(cosine), glm::normalize(axis));
}

Across across(glm::dvec3 direction) {
    const glm::dvec3 other = std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(other, direction));
    return {u, glm::cross(direction, u)};
}

std::optional<glm::dvec3> on_plane(const ScreenMap& map, glm::dvec3 place, glm::dvec3 normal,
                                   glm::dvec2 cursor_px) {
    const Ray ray = ray_through(map, cursor_px);
    const double steepness = glm::dot(ray.direction, normal);
    if (std::abs(steepness) < 0.035) return {};  // sine of 2 degrees
    const double t = glm::dot(place - ray.origin, normal) / steepness;
    if (!(t > 0)) return {};
    return ray.origin + t * ray.direction;
}

glm::dvec3 snapped_direction(glm::dvec3 direction) {
    const double step = pi / 12;
    const double height = std::round(std::asin(std::clamp(direction.y, -1.0, 1.0)) / step) * step;
    const double round_y = std::round(std::atan2(direction.x, direction.z) / step) * step;
    return {std::cos(height) * std::sin(round_y), std::sin(height), std::cos(height) * std::cos(round_y)};
}

}  // namespace glint
