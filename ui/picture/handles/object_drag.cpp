#include "ui/picture/handles/object_drag.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "models/numbers.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

using std::numbers::pi;
constexpr double least_scale = 0.01;

std::size_t axis_of(GizmoPart part) { return static_cast<std::size_t>(part) % 3; }

bool is_axis(GizmoPart part) { return part <= GizmoPart::Z; }

Transform moved(const ObjectDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    const ObjectGizmo& g = drag.gizmo;
    glm::dvec3 motion(0);
    if (is_axis(drag.part)) {
        const glm::dvec3 axis = g.axes[axis_of(drag.part)];
        motion = (along_line(view.map, g.origin, axis, cursor_px) -
                  along_line(view.map, g.origin, axis, drag.grabbed_px)) *
                 axis;
    } else if (drag.part == GizmoPart::Free) {
        const double depth = project(view.map, g.origin).depth;
        motion = unproject(view.map, cursor_px, depth) - unproject(view.map, drag.grabbed_px, depth);
    } else {
        const glm::dvec3 normal = g.axes[axis_of(drag.part)];
        const auto from = on_plane(view.map, g.origin, normal, drag.grabbed_px),
                   to = on_plane(view.map, g.origin, normal, cursor_px);
        if (from && to) motion = *to - *from;
    }
    Transform t = drag.start;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(motion[i]) < 1e-12) continue;
        const double place = double(t.translate[i]) + motion[i];
        t.translate[i] = float(snap ? std::round(place / view.snap_step) * view.snap_step : place);
    }
    return t;
}

/// Returns the axis about which a ring turns: its own, or the line of sight to the object.
glm::dvec3 ring_axis(const ObjectGizmo& gizmo, GizmoPart part) {
    return is_axis(part) ? gizmo.axes[axis_of(part)] : gizmo.to_eye;
}

Transform turned(const ObjectDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    const ObjectGizmo& g = drag.gizmo;
    const glm::dvec3 axis = ring_axis(g, drag.part);
    const Dome circle{g.origin, g.length};
    // The object turns by the angle from the grabbed point of the ring to the cursor.
    const glm::dvec3 start = across(axis).u;
    const double from = turn_towards(view.map, circle, start, axis, drag.grabbed_px);
    const glm::dvec3 held = rotated(start, axis, from);
    double angle = turn_towards(view.map, circle, held, axis, cursor_px);
    if (snap) angle = std::round(angle / (15 * degree)) * 15 * degree;
    Transform t = drag.start;
    if (std::abs(angle) < 1e-9) return t;
    const glm::dmat3 turn(rotated({1, 0, 0}, axis, angle), rotated({0, 1, 0}, axis, angle),
                          rotated({0, 0, 1}, axis, angle));
    t.rotate_deg = euler_deg(turn * rotation_of(drag.start), drag.start.rotate_deg);
    const glm::dvec3 arm = glm::dvec3(drag.start.translate) - g.origin;
    if (arm != glm::dvec3(0)) t.translate = glm::vec3(g.origin + turn * arm);
    return t;
}

/// Moves a scaled object so that the gizmo stays in place.
void keep_place(Transform& t, const ObjectDrag& drag) {
    const glm::dvec3 arm = glm::dvec3(drag.start.translate) - drag.gizmo.origin;
    if (arm == glm::dvec3(0)) return;
    const glm::dmat3 own = rotation_of(drag.start);
    const glm::dvec3 stretched =
        glm::transpose(own) * arm * glm::dvec3(t.scale) / glm::dvec3(drag.start.scale);
    t.translate = glm::vec3(drag.gizmo.origin + own * stretched);
}

float scaled(float scale, double factor, bool snap) {
    const double size = std::max(std::abs(double(scale)) * std::max(factor, 0.0), least_scale);
    const double rounded = snap ? std::max(std::round(size * 10), 1.0) / 10 : size;
    return float(scale < 0 ? -rounded : rounded);
}

Transform resized(const ObjectDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    const ObjectGizmo& g = drag.gizmo;
    Transform t = drag.start;
    if (!is_axis(drag.part)) {
        // Moving away from the centre, to the right or up enlarges the object by a factor of e per third of
        // the picture's height.
        const glm::dvec2 way = cursor_px - drag.grabbed_px;
        const double factor = std::exp(3 * (way.x - way.y) / view.map.size.height);
        for (int i = 0; i < 3; ++i) t.scale[i] = scaled(t.scale[i], factor, snap);
        keep_place(t, drag);
        return t;
    }
    const glm::dvec3 axis = g.axes[axis_of(drag.part)];
    const double from = along_line(view.map, g.origin, axis, drag.grabbed_px),
                 to = along_line(view.map, g.origin, axis, cursor_px);
    float& scale = t.scale[static_cast<int>(axis_of(drag.part))];
    if (std::abs(from) > 1e-3 * g.length) scale = scaled(scale, to / from, snap);
    keep_place(t, drag);
    return t;
}

/// Returns the distance of the cursor from a line on the screen; very large if the line is not in front of
/// the eye.
double distance_to_line(const PictureView& view, glm::dvec3 a, glm::dvec3 b, glm::dvec2 cursor_px) {
    const ProjectedPoint from = project(view.map, a), to = project(view.map, b);
    if (!from.in_front || !to.in_front) return 1e9;
    const glm::dvec2 way = to.pixel - from.pixel;
    const double length = glm::dot(way, way);
    const double t = length > 0 ? std::clamp(glm::dot(cursor_px - from.pixel, way) / length, 0.0, 1.0) : 0;
    return glm::length(from.pixel + t * way - cursor_px);
}

double distance_to_ring(const ObjectGizmo& gizmo, glm::dvec3 axis, double radius, const PictureView& view,
                        glm::dvec2 cursor_px) {
    const auto [u, v] = across(axis);
    double nearest = 1e9;
    constexpr int sides = 64;
    for (int i = 0; i < sides; ++i) {
        const auto point = [&, u = u, v = v](int k) {
            const double a = 2 * pi * k / sides;
            return gizmo.origin + radius * (std::cos(a) * u + std::sin(a) * v);
        };
        nearest = std::min(nearest, distance_to_line(view, point(i), point(i + 1), cursor_px));
    }
    return nearest;
}

/// Finds the nearest axis or ring within reach of the cursor.
std::optional<GizmoPart> axis_under(const ObjectGizmo& gizmo, GizmoMode mode, const PictureView& view,
                                    glm::dvec2 cursor_px, double reach) {
    std::optional<GizmoPart> best;
    double nearest = reach;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 axis = gizmo.axes[i];
        const double distance = mode == GizmoMode::Rotate
                                    ? distance_to_ring(gizmo, axis, gizmo.length, view, cursor_px)
                                    : distance_to_line(view, gizmo.origin + 0.2 * gizmo.length * axis,
                                                       gizmo.origin + 1.1 * gizmo.length * axis, cursor_px);
        if (distance > nearest) continue;
        nearest = distance;
        best = static_cast<GizmoPart>(i);
    }
    return best;
}

std::optional<GizmoPart> plane_under(const ObjectGizmo& gizmo, const PictureView& view,
                                     glm::dvec2 cursor_px) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto there = on_plane(view.map, gizmo.origin, gizmo.axes[i], cursor_px);
        if (!there) continue;
        const glm::dvec3 way = (*there - gizmo.origin) / gizmo.length;
        const double a = glm::dot(way, gizmo.axes[(i + 1) % 3]), b = glm::dot(way, gizmo.axes[(i + 2) % 3]);
        if (a > plane_from && a < plane_to && b > plane_from && b < plane_to)
            return static_cast<GizmoPart>(i + 3);
    }
    return {};
}

}  // namespace

glm::dmat3 rotation_of(const Transform& transform) {
    Transform turn;
    turn.rotate_deg = transform.rotate_deg;
    return glm::dmat3(world_from_object(turn));
}

std::optional<GizmoPart> gizmo_under(const ObjectGizmo& gizmo, GizmoMode mode, const PictureView& view,
                                     glm::dvec2 cursor_px) {
    const double unit = view.pixels(1);
    const double from_middle = glm::length(project(view.map, gizmo.origin).pixel - cursor_px);
    if (mode != GizmoMode::Rotate && from_middle < 9 * unit) return GizmoPart::Free;
    if (const auto axis = axis_under(gizmo, mode, view, cursor_px, 7 * unit)) return axis;
    if (mode == GizmoMode::Move) return plane_under(gizmo, view, cursor_px);
    if (mode == GizmoMode::Rotate &&
        distance_to_ring(gizmo, gizmo.to_eye, 1.18 * gizmo.length, view, cursor_px) < 7 * unit)
        return GizmoPart::Free;
    return {};
}

Transform dragged_object(const ObjectDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap) {
    switch (drag.mode) {
    case GizmoMode::None:
        return drag.start;
    case GizmoMode::Move:
        return moved(drag, view, cursor_px, snap);
    case GizmoMode::Rotate:
        return turned(drag, view, cursor_px, snap);
    case GizmoMode::Scale:
        return resized(drag, view, cursor_px, snap);
    }
    return drag.start;  // not reached
}

glm::vec3 euler_deg(const glm::dmat3& r, glm::vec3 near_deg) {
    const glm::dvec3 near = glm::dvec3(near_deg) * degree;
    // Rz Ry Rx has -sin y at column 0, row 2; the rest follows from that column and that row.
    const double sine = std::clamp(-r[0][2], -1.0, 1.0), y = std::asin(sine);
    glm::dvec3 candidates[2];
    if (std::abs(sine) > 1 - 1e-9) {
        const double sum = std::atan2(-r[1][0], r[1][1]);  // z - x where y = 90, z + x where y = -90
        candidates[0] = candidates[1] = {near.x, y, sine > 0 ? sum + near.x : sum - near.x};
    } else {
        candidates[0] = {std::atan2(r[1][2], r[2][2]), y, std::atan2(r[0][1], r[0][0])};
        candidates[1] = {candidates[0].x + pi, pi - y, candidates[0].z + pi};
    }
    glm::dvec3 best = near;
    double least = 1e9;
    for (glm::dvec3 c : candidates) {
        for (int i = 0; i < 3; ++i) c[i] += std::round((near[i] - c[i]) / (2 * pi)) * 2 * pi;
        const double away = std::abs(c.x - near.x) + std::abs(c.y - near.y) + std::abs(c.z - near.z);
        if (away >= least) continue;
        least = away;
        best = c;
    }
    // A thousandth of a degree is finer than any mouse movement, and 45 stays exactly 45.
    return glm::vec3(std::round(best.x / degree * 1000) / 1000, std::round(best.y / degree * 1000) / 1000,
                     std::round(best.z / degree * 1000) / 1000);
}

// Positions and draws the gizmo of an object.

namespace {

const std::array axis_colours{ImVec4{0.93f, 0.42f, 0.35f, 1}, ImVec4{0.52f, 0.78f, 0.35f, 1},
                              ImVec4{0.42f, 0.65f, 1.0f, 1}};
constexpr const char* letters[] = {"X", "Y", "Z"};
const ImVec4 all_axes_colour{1, 1, 1, 1};
constexpr float axis_units = 84;                    // design units
constexpr float axis_width = 2.2f, held_width = 3;  // logical pixels

struct GizmoPen {
    WorldPen pen;
    const ObjectGizmo& gizmo;
    std::optional<GizmoPart> in_hand;

    [[nodiscard]] ImU32 colour(std::size_t axis, GizmoPart part) const {
        return to_u32(in_hand == part ? all_axes_colour : axis_colours[axis]);
    }
    [[nodiscard]] ImVec2 shown(glm::dvec3 place) const { return pen.view.shown(place); }
    void letter(std::size_t axis, glm::dvec3 at) const {
        ImGui::PushFont(fonts().small);
        rimmed_text(pen.list, shown(at), axis_colours[axis], letters[axis]);
        ImGui::PopFont();
    }
    /// Draws the end of an axis: a box if it scales or is seen end-on, else an arrowhead.
    void head(std::size_t axis, GizmoMode mode) const {
        const ImU32 tint = colour(axis, static_cast<GizmoPart>(axis));
        const ImVec2 tip = shown(gizmo.origin + gizmo.length * gizmo.axes[axis]);
        const ImVec2 way = tip - shown(gizmo.origin);
        const float length = length_of(way);
        if (mode != GizmoMode::Scale && length >= px(6))
            return arrow_head(pen.list, tip + px(6.5f) / length * way, way / length, 13, 5, tint);
        const ImVec2 half = px(4.5f) * ImVec2(1, 1), rim{1, 1};
        pen.list.AddRectFilled(tip - half - rim, tip + half + rim, rim_colour());
        pen.list.AddRectFilled(tip - half, tip + half, tint);
    }
    void axis(std::size_t i, GizmoMode mode) const {
        const auto part = static_cast<GizmoPart>(i);
        const glm::dvec3 way = gizmo.length * gizmo.axes[i];
        pen.cased(gizmo.origin + 0.14 * way, gizmo.origin + way, colour(i, part), 1,
                  in_hand == part ? held_width : axis_width);
        head(i, mode);
        letter(i, gizmo.origin + 1.22 * way);
    }
    void plane(std::size_t i) const {
        const auto part = static_cast<GizmoPart>(i + 3);
        const glm::dvec3 a = gizmo.length * gizmo.axes[(i + 1) % 3],
                         b = gizmo.length * gizmo.axes[(i + 2) % 3];
        if (std::abs(glm::dot(gizmo.axes[i], gizmo.to_eye)) < 0.12) return;  // edge-on
        const ImVec2 corners[] = {shown(gizmo.origin + plane_from * a + plane_from * b),
                                  shown(gizmo.origin + plane_to * a + plane_from * b),
                                  shown(gizmo.origin + plane_to * a + plane_to * b),
                                  shown(gizmo.origin + plane_from * a + plane_to * b)};
        const ImVec4 tint = in_hand == part ? all_axes_colour : axis_colours[i];
        pen.list.AddConvexPolyFilled(corners, 4, to_u32(tint, 0.45f));
        pen.list.AddPolyline(corners, 4, to_u32(tint), ImDrawFlags_Closed, px(1.2f));
    }
    /// Draws a ring; the half that faces away is thin.
    void ring(glm::dvec3 axis, double radius, ImU32 c, bool held, bool whole) const {
        const auto [u, v] = across(axis);
        constexpr int sides = 64;
        const auto out = [&, u = u, v = v](int k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            return std::cos(angle) * u + std::sin(angle) * v;
        };
        for (int i = 0; i < sides; ++i) {
            const glm::dvec3 a = gizmo.origin + radius * out(i), b = gizmo.origin + radius * out(i + 1);
            if (whole || glm::dot(out(i), gizmo.to_eye) > -0.05)
                pen.cased(a, b, c, 1, held ? held_width : axis_width);
            else
                pen.line(a, b, (c & 0x00FFFFFFu) | 0x60000000u, px(1));
        }
    }
};

}  // namespace

glm::dvec3 gizmo_anchor(const Object& object, const PictureView& view) {
    if (!object.mesh) return glm::dvec3(0);
    const Bounds& box = object.mesh->bounds;
    const bool in_bounds = glm::all(glm::lessThanEqual(box.min, glm::vec3(0))) &&
                           glm::all(glm::lessThanEqual(glm::vec3(0), box.max));
    const glm::dvec3 middle = (glm::dvec3(box.min) + glm::dvec3(box.max)) / 2.0;
    const glm::dmat4 world = world_from_object(object.transform);
    const auto is_seen = [&](glm::dvec3 place) {
        const ProjectedPoint at = project(view.map, glm::dvec3(world * glm::dvec4(place, 1)));
        return at.in_front && is_inside(view.map.size, at.pixel);
    };
    const bool stays = in_bounds && (is_seen(glm::dvec3(0)) || !is_seen(middle));
    return stays ? glm::dvec3(0) : middle;
}

std::optional<ObjectGizmo> gizmo_of(const Transform& transform, GizmoMode mode, const PictureView& view,
                                    const GizmoPlace& place) {
    if (mode == GizmoMode::None) return {};
    ObjectGizmo gizmo;
    gizmo.anchor = place.anchor;
    gizmo.origin = place.pivot && mode == GizmoMode::Rotate
                       ? *place.pivot
                       : glm::dvec3(world_from_object(transform) * glm::dvec4(place.anchor, 1));
    const ProjectedPoint at = project(view.map, gizmo.origin);
    if (!at.in_front || at.depth <= 0) return {};
    const glm::dvec2 end = at.pixel + glm::dvec2(view.pixels(axis_units), 0);
    gizmo.length = glm::length(unproject(view.map, end, at.depth) - gizmo.origin);
    gizmo.to_eye = -ray_through(view.map, at.pixel).direction;
    const glm::dmat3 own = mode == GizmoMode::Scale ? rotation_of(transform) : glm::dmat3(1);
    for (int i = 0; i < 3; ++i) gizmo.axes[static_cast<std::size_t>(i)] = own[i];
    return gizmo;
}

void draw_object_gizmo(ImDrawList& list, const PictureView& view, const ObjectGizmo& gizmo, GizmoMode mode,
                       std::optional<GizmoPart> in_hand) {
    const GizmoPen pen{{list, view}, gizmo, in_hand};
    if (mode == GizmoMode::Rotate) {
        const bool free = in_hand == GizmoPart::Free;
        pen.ring(gizmo.to_eye, 1.18 * gizmo.length, to_u32(all_axes_colour, free ? 1.0f : 0.55f), free, true);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto part = static_cast<GizmoPart>(i);
            pen.ring(gizmo.axes[i], gizmo.length, pen.colour(i, part), in_hand == part, false);
        }
        return;
    }
    if (mode == GizmoMode::Move)
        for (std::size_t i = 0; i < 3; ++i) pen.plane(i);
    for (std::size_t i = 0; i < 3; ++i) pen.axis(i, mode);
    const bool free = in_hand == GizmoPart::Free;
    cased_circle(list, pen.shown(gizmo.origin), 6, to_u32(all_axes_colour, free ? 1.0f : 0.8f), free ? 3 : 2);
}

}  // namespace glint
