// Positions and draws the gizmo of an object.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "ui/picture/handles/object_drag.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"

namespace glint {
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
