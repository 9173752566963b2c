// The shapes of lights: a spot's cone and a panel's rectangle.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "renderer/reflectance/highlight.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

using std::numbers::pi;
constexpr double least_edge = 1e-3;  // minimum size of a panel, as a fraction of its previous size

/// Returns the direction in which a light shines, a unit vector in the world: a cone's axis or a panel's
/// normal.
glm::dvec3 aim_of(const Light& light, const DragView& view) {
    if (const auto cone = cone_of(light, view.dome, view.map)) return cone->axis;
    if (const auto panel = panel_of(light, view.map)) return panel->normal();
    return {0, -1, 0};
}

Light turned_towards(Light light, glm::dvec3 aim, const DragView& view) {
    turn_shape(light, rotation_between(aim_of(light, view), aim), view.map);
    return light;
}

/// Changes the cutoff or the inner angle to follow the cursor.
Light with_cone(const ShapeDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    Light light = drag.start;
    const auto cone = cone_of(light, view.dome, view.map);
    if (!cone) return light;
    const bool is_inner = drag.grip.part == ShapePart::Inner;
    const double angle = is_inner ? cone->inner : cone->angle;
    const glm::dvec3 side = std::cos(drag.grip.azimuth) * cone->u + std::sin(drag.grip.azimuth) * cone->v;
    // The circle's points rotate about the light, in the plane of the axis and the grabbed point.
    const glm::dvec3 grabbed = cone->ring(drag.grip.azimuth, angle),
                     hand = (grabbed - cone->place) / cone->slant;
    const glm::dvec2 offset = project(view.map, grabbed).pixel - drag.grabbed_px;
    const double turn = turn_towards(view.map, {cone->place, cone->slant}, hand, glm::cross(cone->axis, side),
                                     cursor_px + offset);
    double wanted = (angle + turn) * 180 / pi;
    if (snap) wanted = std::round(wanted / 5) * 5;
    const double most = is_inner ? double(light.spot.cutoff_deg) : 90;
    (is_inner ? light.spot.inner_deg : light.spot.cutoff_deg) =
        static_cast<float>(std::clamp(wanted, 0.0, most));
    return light;
}

Light with_edges(const ShapeDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    Light light = drag.start;
    const auto panel = panel_of(light, view.map);
    if (!panel) return light;
    const glm::dvec3 grip = panel->point(drag.grip.at);
    const glm::dvec2 offset = project(view.map, grip).pixel - drag.grabbed_px;
    const auto there = on_plane(view.map, panel->place, panel->normal(), cursor_px + offset);
    if (!there) return light;
    // Position = place + a u + b v; the edges need not be perpendicular.
    const glm::dvec3 way = *there - panel->place;
    const double uu = glm::dot(panel->u, panel->u), uv = glm::dot(panel->u, panel->v),
                 vv = glm::dot(panel->v, panel->v), det = uu * vv - uv * uv;
    const double wu = glm::dot(way, panel->u), wv = glm::dot(way, panel->v);
    const double a = (wu * vv - wv * uv) / det, b = (wv * uu - wu * uv) / det;
    // If the cursor has passed the centre, the opposite corner is under the cursor.
    const auto scaled = [&](glm::vec3 edge, double share) {
        double length = double(glm::length(edge)) * std::max(std::abs(share), least_edge);
        if (snap) length = std::max(std::round(length / view.snap_step), 1.0) * view.snap_step;
        return glm::vec3(glm::normalize(glm::dvec3(edge)) * length);
    };
    if (drag.grip.at.x != 0) light.area.edge_u = scaled(light.area.edge_u, a * drag.grip.at.x);
    if (drag.grip.at.y != 0) light.area.edge_v = scaled(light.area.edge_v, b * drag.grip.at.y);
    return light;
}

Light with_aim(const ShapeDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    const glm::dvec3 place = handle_of(drag.start, view.dome, view.map);
    const glm::dvec3 aim = aim_of(drag.start, view);
    const double reach = glm::length(drag.grip.place - place);
    const ProjectedPoint tip = project(view.map, drag.grip.place);
    if (!tip.in_front || !(reach > 0)) return drag.start;
    const bool nearer = glm::dot(aim, ray_through(view.map, tip.pixel).direction) <= 0;
    const Ray ray = ray_through(view.map, tip.pixel + cursor_px - drag.grabbed_px);
    const glm::dvec3 wanted = glm::normalize(on_dome({place, reach}, ray, nearer) - place);
    return turned_towards(drag.start, snap ? snapped_direction(wanted) : wanted, view);
}

ShapeGrip inner_grip(const ConeShape& cone, double azimuth) {
    return {ShapePart::Inner, azimuth, {}, cone.ring(azimuth, cone.inner)};
}

}  // namespace

glm::dvec3 ConeShape::ring(double azimuth, double from_axis) const {
    return middle(from_axis) + slant * std::sin(from_axis) * (std::cos(azimuth) * u + std::sin(azimuth) * v);
}

std::optional<ConeShape> cone_of(const Light& light, const Dome& dome, const ScreenMap& map) {
    if (light.kind != LightKind::Spot || light.spot.cutoff_deg > 90) return {};
    ConeShape cone;
    cone.place = handle_of(light, dome, map);
    cone.axis = glm::normalize(to_world(light, light.spot.direction, 0, map));
    const Across sides = across(cone.axis);
    cone.u = sides.u, cone.v = sides.v;
    cone.slant = std::max(0.35 * glm::length(dome.centre - cone.place), 0.2 * dome.radius);
    cone.angle = double(light.spot.cutoff_deg) * pi / 180;
    cone.inner = double(light.spot.inner_deg) * pi / 180;
    return cone;
}

glm::dvec3 PanelShape::normal() const { return glm::normalize(glm::cross(u, v)); }

glm::dvec3 PanelShape::tip() const {
    return place + 1.5 * std::max(glm::length(u), glm::length(v)) * normal();
}

std::optional<PanelShape> panel_of(const Light& light, const ScreenMap& map) {
    if (light.kind != LightKind::Area) return {};
    return PanelShape{handle_of(light, {}, map), to_world(light, light.area.edge_u, 0, map),
                      to_world(light, light.area.edge_v, 0, map)};
}

std::vector<ShapeGrip> shape_grips(const Light& light, const Dome& dome, const ScreenMap& map) {
    std::vector<ShapeGrip> grips;
    if (const auto cone = cone_of(light, dome, map)) {
        grips.push_back({ShapePart::Aim, 0, {}, cone->tip()});
        for (int i = 0; i < 4; ++i) grips.push_back({ShapePart::Rim, i * pi / 2, {}, cone->rim(i * pi / 2)});
        for (int i = 0; i < 2 && cone->is_soft(); ++i) grips.push_back(inner_grip(*cone, (i + 0.25) * pi));
    }
    if (const auto panel = panel_of(light, map)) {
        grips.push_back({ShapePart::Aim, 0, {}, panel->tip()});
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y) {
                if (x == 0 && y == 0) continue;
                const ShapePart part = x != 0 && y != 0 ? ShapePart::Corner : ShapePart::Edge;
                grips.push_back({part, 0, {x, y}, panel->point({x, y})});
            }
    }
    return grips;
}

glm::dvec3 place_of(const ShapeGrip& grip, const Light& light, const Dome& dome, const ScreenMap& map) {
    if (const auto cone = cone_of(light, dome, map))
        return grip.part == ShapePart::Rim     ? cone->rim(grip.azimuth)
               : grip.part == ShapePart::Inner ? cone->ring(grip.azimuth, cone->inner)
                                               : cone->tip();
    if (const auto panel = panel_of(light, map))
        return grip.part == ShapePart::Aim ? panel->tip() : panel->point(grip.at);
    return grip.place;
}

std::optional<ShapeGrip> shape_under(const Light& light, const PictureView& view, glm::dvec2 cursor_px) {
    std::optional<ShapeGrip> best;
    double nearest = view.pixels(8);
    const auto offer = [&](const ShapeGrip& grip) {
        const ProjectedPoint at = project(view.map, grip.place);
        const double distance = glm::length(at.pixel - cursor_px);
        if (!at.in_front || distance > nearest) return;
        nearest = distance;
        best = grip;
    };
    for (const ShapeGrip& grip : shape_grips(light, view.dome, view.map)) offer(grip);
    if (best) return best;
    if (const auto cone = cone_of(light, view.dome, view.map))
        for (int i = 0; i < 180; ++i) {
            offer({ShapePart::Rim, i * pi / 90, {}, cone->rim(i * pi / 90)});
            if (cone->is_soft()) offer(inner_grip(*cone, i * pi / 90));
        }
    return best;
}

Light dragged_shape(const ShapeDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    switch (drag.grip.part) {
    case ShapePart::Rim:
    case ShapePart::Inner:
        return with_cone(drag, view, cursor_px, snap);
    case ShapePart::Aim:
        return with_aim(drag, view, cursor_px, snap);
    case ShapePart::Corner:
    case ShapePart::Edge:
        return with_edges(drag, view, cursor_px, snap);
    }
    return drag.start;  // not reached
}

Light aimed_at(const Light& light, glm::dvec3 place, const DragView& view, bool snap) {
    const glm::dvec3 way = place - handle_of(light, view.dome, view.map);
    if (!(glm::length(way) > 1e-9)) return light;
    const glm::dvec3 aim = glm::normalize(way);
    return turned_towards(light, snap ? snapped_direction(aim) : aim, view);
}

// Dragging a light by its handle and by its terminator.

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
        // A factor of e per third of the picture's height gives the same relative precision near and far.
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
