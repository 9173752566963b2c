#include "ui/picture/handles/light_handles.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "ui/widgets/fonts.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"

namespace glint {
namespace {

using std::numbers::pi;
constexpr float handle_radius = 7, grip_radius = 13;

/// The point on the picture's border in the direction of a point outside.
glm::dvec2 on_border(const ProjectedPoint& at, glm::dvec3 in_view, PictureSize size, double margin) {
    const glm::dvec2 middle{size.width / 2.0, size.height / 2.0};
    glm::dvec2 way = at.in_front ? at.pixel - middle : glm::dvec2(in_view.x, -in_view.y);
    if (glm::length(way) < 1e-9) way = {0, -1};  // exactly at the eye: shown at the top
    const glm::dvec2 half = middle - margin;
    const double reach =
        std::min(half.x / std::max(std::abs(way.x), 1e-12), half.y / std::max(std::abs(way.y), 1e-12));
    return middle + way * reach;
}

void draw_stem(const WorldPen& pen, glm::dvec3 place, ImU32 colour, float opacity) {
    const glm::dvec3 foot{place.x, pen.view.bounds.min.y, place.z};
    pen.cased(place, foot, colour, opacity, 1);
    const double radius = 0.06 * pen.view.dome.radius;  // proportional to the zoom
    pen.circle(foot, {radius, 0, 0}, {0, 0, radius}, colour, opacity);
}

void draw_cone(const WorldPen& pen, const Light& light, ImU32 colour, float opacity) {
    const auto cone = cone_of(light, pen.view.dome, pen.view.map);
    if (!cone) return;
    const auto circle = [&](double angle, float share) {
        const double radius = cone->slant * std::sin(angle);
        pen.circle(cone->middle(angle), radius * cone->u, radius * cone->v, colour, share * opacity);
    };
    circle(cone->angle, 1);
    if (cone->is_soft()) circle(cone->inner, 0.6f);
    for (int i = 0; i < 4; ++i) pen.cased(cone->place, cone->rim(i * pi / 2), colour, opacity);
}

/// The stick that aims a light, and its draggable marks.
void draw_shape_grips(const WorldPen& pen, const Light& light, glm::dvec3 place, ImU32 colour, float opacity,
                      const std::optional<glm::dvec3>& in_hand) {
    for (const ShapeGrip& grip : shape_grips(light, pen.view.dome, pen.view.map)) {
        if (grip.part == ShapePart::Aim) pen.cased(place, grip.place, colour, 0.6f * opacity);
        pen.mark(grip.place, colour, opacity, in_hand && glm::length(*in_hand - grip.place) < 1e-9);
    }
    if (in_hand) pen.mark(*in_hand, colour, opacity, true);
}

void draw_rays(const WorldPen& pen, const Light& light, glm::dvec3 place, ImU32 colour, float opacity) {
    const glm::dvec3 towards = -direction_of(light, pen.view.map);
    const double length = 0.3 * pen.view.dome.radius, aside = 0.05 * pen.view.dome.radius;
    const auto [u, v] = across(towards);
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 from = place + aside * ((i & 1 ? 1.0 : -1.0) * u + (i & 2 ? 1.0 : -1.0) * v);
        pen.cased(from, from + length * towards, colour, opacity);
    }
}

void draw_rectangle(const WorldPen& pen, const Light& light, ImU32 colour, float opacity) {
    const auto panel = panel_of(light, pen.view.map);
    const glm::dvec2 corners[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    for (int i = 0; i < 4; ++i)
        pen.cased(panel->point(corners[i]), panel->point(corners[(i + 1) % 4]), colour, opacity);
}

void draw_shape(const WorldPen& pen, const Light& light, const Handle& handle, ImU32 colour, float opacity) {
    switch (light.kind) {
    case LightKind::Directional:
        return draw_rays(pen, light, handle.place, colour, opacity);
    case LightKind::Point:
        return;
    case LightKind::Spot:
        return draw_cone(pen, light, colour, opacity);
    case LightKind::Area:
        return draw_rectangle(pen, light, colour, opacity);
    }
}

/// An arrow on the picture's border that points to a light outside.
void draw_way_out(ImDrawList& list, const PictureView& view, glm::dvec2 pixel, ImU32 colour) {
    const glm::dvec2 middle{view.map.size.width / 2.0, view.map.size.height / 2.0};
    const glm::dvec2 way = glm::normalize(pixel - middle), side{-way.y, way.x};
    const double unit = view.pixels(1);
    const auto at = [&](double along, double across) {
        return view.to_window(pixel + unit * (along * way + across * side));
    };
    list.AddTriangleFilled(at(15, 0), at(10, 5), at(10, -5), colour);
}

/// Draws the grip: a disc of the light's colour with a dark rim; rays for a sun; a ring when it is off.
void draw_grip(ImDrawList& list, ImVec2 at, const Light& light, HandleLook look, float opacity) {
    const float radius = look.hovered ? handle_radius + 1.5f : handle_radius, r = px(radius);
    const ImU32 colour = to_u32(colour_of(light), opacity);
    if (light.kind == LightKind::Directional)
        for (int i = 0; i < 8; ++i) {
            const float a = float(i * pi / 4);
            const ImVec2 way = r * ImVec2(std::cos(a), std::sin(a));
            cased_line(list, at + 1.35f * way, at + 1.95f * way, colour, 2, opacity);
        }
    draw_light_disc(list, at, radius, light, colour, opacity);
    if (light.enabled && light.space == LightSpace::Camera)
        list.AddCircleFilled(at, r * 0.38f, rim_colour(opacity));
    if (look.selected) list.AddCircle(at, r + px(4), to_u32(theme().accent, opacity), 0, px(2));
    if (look.matters) cased_circle(list, at, radius + 7.5f, to_u32(colour_of(light), opacity), 1.2f);
    if (look.hovered) list.AddCircle(at, r + px(1.5f), to_u32({1, 1, 1, 1}, opacity), 0, px(1.5f));
}

}  // namespace

std::vector<Handle> light_handles(const Scene& scene, const PictureView& view, int selected) {
    constexpr int most = 300;
    std::vector<Handle> handles;
    const PictureSize size = view.map.size;
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
        if (i >= most && i != selected) continue;
        Handle handle{
            i, handle_of(scene.lights[static_cast<std::size_t>(i)], view.dome, view.map), {}, false};
        handle.at = project(view.map, handle.place);
        handle.in_picture = handle.at.in_front && is_inside(size, handle.at.pixel);
        if (!handle.in_picture) {
            const glm::dvec3 in_view(view.map.view_from_world * glm::dvec4(handle.place, 1));
            handle.at.pixel = on_border(handle.at, in_view, size, view.pixels(18));
        }
        handles.push_back(handle);
    }
    return handles;
}

const Handle* handle_under(const std::vector<Handle>& handles, glm::dvec2 cursor_px,
                           const PictureView& view) {
    const Handle* best = nullptr;
    double nearest = view.pixels(grip_radius);
    for (const Handle& handle : handles) {
        const double distance = glm::length(handle.at.pixel - cursor_px);
        if (distance <= nearest) {
            nearest = distance;
            best = &handle;
        }
    }
    return best;
}

void draw_light_disc(ImDrawList& list, ImVec2 at, float radius, const Light& light, ImU32 colour,
                     float opacity) {
    if (light.enabled) return rimmed_disc(list, at, radius, colour, opacity);
    list.AddCircleFilled(at, px(radius + 1.5f), rim_colour(opacity));
    list.AddCircle(at, px(radius - 1), colour, 0, px(2));
}

void draw_handle(ImDrawList& list, const PictureView& view, const Light& light, const Handle& handle,
                 HandleLook look) {
    const float opacity = look.hidden && !look.selected && !look.hovered ? 0.35f
                          : light.enabled                                ? 1.0f
                                                                         : 0.6f;
    const WorldPen pen{list, view};
    const ImU32 colour = to_u32(colour_of(light), opacity);
    const bool in_hand = look.selected || look.hovered;
    if (handle.in_picture || look.selected) {
        const bool stem = in_hand || (look.stem && light.space == LightSpace::World);
        if (light.kind != LightKind::Directional && stem)
            draw_stem(pen, handle.place, to_u32(colour_of(light), 0.55f * opacity), opacity);
        if (in_hand || light.kind == LightKind::Area) draw_shape(pen, light, handle, colour, opacity);
        if (look.selected) draw_shape_grips(pen, light, handle.place, colour, opacity, look.shape_in_hand);
    }
    draw_grip(list, view.to_window(handle.at.pixel), light, look,
              handle.in_picture ? opacity : 0.55f * opacity);
    if (!handle.in_picture) draw_way_out(list, view, handle.at.pixel, colour);
}

namespace {

/// The upper left corner of a note of `size` for a cursor at `at`: next to `clear`, the area to keep free, if
/// there is room on one of its four sides; else next to the cursor.
ImVec2 note_corner(const Rect& picture, ImVec2 at, ImVec2 size, const std::optional<Rect>& clear) {
    const ImVec2 away = px(1) * ImVec2(20, 18), end = picture.high, edge = px(4) * ImVec2(1, 1);
    ImVec2 beside = at + away;
    if (beside.x + size.x > end.x - edge.x) beside.x = at.x - away.x - size.x;
    if (beside.y + size.y > end.y - edge.y) beside.y = at.y - away.y - size.y;
    if (!clear || !overlap(*clear, {beside, beside + size})) return beside;
    const ImVec2 low = picture.low + edge, high = end - edge - size;
    const ImVec2 middle = ImClamp(at - size / 2, low, high);
    const float gap = px(8);
    const ImVec2 sides[] = {{clear->high.x + gap, middle.y},
                            {clear->low.x - gap - size.x, middle.y},
                            {middle.x, clear->low.y - gap - size.y},
                            {middle.x, clear->high.y + gap}};
    std::optional<ImVec2> best;
    for (const ImVec2 side : sides) {
        if (side.x < low.x || side.y < low.y || side.x > high.x || side.y > high.y) continue;
        if (!best || length_of(side + size / 2 - at) < length_of(*best + size / 2 - at)) best = side;
    }
    return best.value_or(beside);
}

}  // namespace

void draw_note(ImDrawList& list, ImVec2 at, const HandNote& note, const std::optional<Rect>& clear) {
    ImGui::PushFont(fonts().small);
    const ImVec2 head = ImGui::CalcTextSize(note.title.c_str());
    ImGui::PushFont(fonts().figures);
    const ImVec2 body = ImGui::CalcTextSize(note.numbers.c_str());
    const ImVec2 pad = px(1) * ImVec2(8, 5);
    const ImVec2 size = ImVec2(std::max(head.x, body.x), head.y + body.y) + 2 * pad;
    const ImVec2 low = note_corner(clip_area(list), at, size, clear);
    badge_ground(list, {low, low + size});
    list_control("Note at the cursor", "", {low, low + size});
    list.AddText(low + pad + ImVec2(0, head.y), to_u32(theme().text), note.numbers.c_str());
    ImGui::PopFont();
    list.AddText(low + pad, to_u32(theme().dim_text), note.title.c_str());
    ImGui::PopFont();
}

}  // namespace glint
