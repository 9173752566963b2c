#include "ui/picture/handles/light_handles.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <numbers>
#include <optional>

#include "models/numbers.h"
#include "renderer/shade/light_sources.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

using std::numbers::pi;
constexpr float handle_radius = 7, grip_radius = 13;

/// Returns the point on the picture's border in the direction of a point outside it.
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
    const double radius = 0.06 * pen.view.dome.radius;  // scales with the zoom
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

/// Draws the stick that aims a light, and its draggable marks.
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

/// Draws an arrow on the picture's border that points to a light outside the picture.
void draw_way_out(ImDrawList& list, const PictureView& view, glm::dvec2 pixel, ImU32 colour) {
    const glm::dvec2 middle{view.map.size.width / 2.0, view.map.size.height / 2.0};
    const glm::dvec2 way = glm::normalize(pixel - middle), side{-way.y, way.x};
    const double unit = view.pixels(1);
    const auto at = [&](double along, double across) {
        return view.to_window(pixel + unit * (along * way + across * side));
    };
    list.AddTriangleFilled(at(15, 0), at(10, 5), at(10, -5), colour);
}

/// Draws the grip: a disc in the light's colour with a dark rim; rays for a sun; a ring when the light is
/// off.
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

/// Returns the upper left corner of a note of `size` for a cursor at `at`: next to `clear`, the area to keep
/// free, if there is room on one of its four sides; else next to the cursor.
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

namespace {

constexpr double faint = 0.01;  // initial intensity when a light of intensity 0 is raised

constexpr LightEffectInfo infos[] = {
    {LightEffect::Brightest, "brightest here, n·l = 1", "The light is in the direction of n",
     "No surface there: the light does not move"},
    {LightEffect::Rim, "behind, as a rim light", "The light comes from behind, 75° off n: the outline is lit",
     "Light from behind cannot reach that point: the light does not move"},
};

/// Returns the unit vector towards the eye, in world coordinates.
glm::dvec3 towards_eye(const SurfaceView& view, glm::dvec3 place) {
    return -ray_through(view.map, project(view.map, place).pixel).direction;
}

/// Returns the unit vector from the point to the light for that effect; nullopt if there is none.
std::optional<glm::dvec3> way_to_light(LightEffect effect, const SurfaceView& view, glm::dvec3 place,
                                       glm::dvec3 n) {
    if (effect == LightEffect::Brightest) return n;
    const glm::dvec3 v = towards_eye(view, place);
    const double facing = glm::dot(n, v);
    if (facing > std::sin(rim_light_deg * degree)) return {};
    const glm::dvec3 away = facing * n - v;  // along the surface, away from the viewer
    const double length = glm::length(away);
    if (length < 1e-6) return {};
    return std::cos(rim_light_deg * degree) * n + std::sin(rim_light_deg * degree) / length * away;
}

double sum_of(glm::vec3 c) { return double(c.x) + double(c.y) + double(c.z); }

}  // namespace

const LightEffectInfo& info_of(LightEffect effect) { return infos[static_cast<std::size_t>(effect)]; }

std::optional<Light> with_effect(LightEffect effect, const Light& light, const SurfaceView& view,
                                 glm::dvec2 pixel) {
    const auto point = seen_at(view.renderer, view.map.size, pixel);
    if (!point) return {};
    const glm::dvec3 place = in_world(view.map, point->position, 1);
    const auto way = way_to_light(effect, view, place, glm::normalize(in_world(view.map, point->normal, 0)));
    if (!way) return {};
    if (light.kind == LightKind::Directional)
        return placed_at(light, view.dome.centre + *way, view.dome, view.map);
    const double distance = std::max(glm::distance(handle_of(light, view.dome, view.map), place), 1e-4);
    const Light moved = placed_at(light, place + distance * *way, view.dome, view.map);
    return aimed_at(moved, place, {view.map, view.dome});
}

glm::vec3 added_by(const ExplainedLight& light) {
    glm::vec3 sum = light.share;
    for (const ExplainedLight& sample : light.samples) sum += sample.share;
    return sum;
}

std::map<int, glm::vec3> added_to_pixel(const Explanation& explanation) {
    std::map<int, glm::vec3> adds;
    const auto add = [&adds](const ExplainedPoint& at, float weight) {
        for (const ExplainedLight& light : at.lights) adds[light.index] += weight * added_by(light);
    };
    if (!explanation.lit_per_corner) add(explanation.at, 1);
    for (const ExplainedCorner& corner : explanation.corners)
        if (explanation.lit_per_corner) add(corner.at, corner.weight);
    return adds;
}

double share_of_pixel(const Explanation& explanation, glm::vec3 added) {
    const double sum = sum_of(explanation.sum);
    return sum > 0 ? std::clamp(sum_of(added) / sum, 0.0, 1.0) : 0;
}

std::optional<MainLight> main_light(const Explanation& explanation) {
    const std::map<int, glm::vec3> adds = added_to_pixel(explanation);
    const auto most = std::max_element(adds.begin(), adds.end(), [](const auto& a, const auto& b) {
        return sum_of(a.second) < sum_of(b.second);
    });
    const double share = most == adds.end() ? 0 : share_of_pixel(explanation, most->second);
    return share > 0 ? std::optional(MainLight{most->first, share}) : std::nullopt;
}

float dimmed(float intensity, double up_px, int height) {
    const double factor = std::exp(std::clamp(3 * up_px / height, -7.0, 7.0));
    if (intensity == 0 && up_px > 0) return static_cast<float>(faint * factor);
    return static_cast<float>(std::min(double(intensity) * factor, 1e6));
}

namespace {

// The renderer defines which matrix transforms a light to camera coordinates
// (renderer/shade/light_sources.h). A light in world space skips the transforms there and back, so its
// numbers stay exactly the same.
glm::dmat4 world_from_own(const Light& light, const ScreenMap& map) {
    const glm::dmat4 carry = camera_from_light(light.space, map.view_from_world);
    return carry == map.view_from_world ? glm::dmat4(1) : map.world_from_view * carry;
}

glm::dmat4 own_from_world(const Light& light, const ScreenMap& map) {
    const glm::dmat4 carry = camera_from_light(light.space, map.view_from_world);
    return carry == map.view_from_world ? glm::dmat4(1) : glm::inverse(carry) * map.view_from_world;
}

glm::dvec3 own_place(const Light& light) {
    const double w = light.position.w;
    return glm::dvec3(light.position) / (w == 0 ? 1.0 : w);
}

void widen(Bounds& bounds, const Object& object) {
    const glm::dmat4 world = world_from_object(object.transform);
    for (const glm::dvec3& corner : corners_of(object.mesh->bounds)) {
        const glm::vec3 place(world * glm::dvec4(corner, 1));
        bounds.min = glm::min(bounds.min, place);
        bounds.max = glm::max(bounds.max, place);
    }
}

}  // namespace

Bounds scene_bounds(const Scene& scene) {
    constexpr float huge = 3e38f;
    Bounds bounds{glm::vec3(huge), glm::vec3(-huge)};
    for (const Object& object : scene.objects)
        if (object.mesh && object.visible) widen(bounds, object);
    if (bounds.min.x > bounds.max.x) return {scene.camera.target - 1.0f, scene.camera.target + 1.0f};
    return bounds;
}

double ground_height(const Scene& scene) {
    constexpr float level = 1e-3f;  // the maximum height of a horizontal object, as a fraction of its width
    const Bounds all = scene_bounds(scene);
    const float middle = (all.min.y + all.max.y) / 2;  // excludes ceilings, which are above the middle
    double height = all.min.y;
    float widest = 0;
    for (const Object& object : scene.objects) {
        if (!object.mesh || !object.visible) continue;
        constexpr float huge = 3e38f;
        Bounds bounds{glm::vec3(huge), glm::vec3(-huge)};
        widen(bounds, object);
        const glm::vec3 size = bounds.max - bounds.min;
        const float width = std::min(size.x, size.z);
        if (size.y > level * width || width <= widest || bounds.max.y > middle) continue;
        widest = width;
        height = bounds.max.y;
    }
    return height;
}

Dome sun_dome(glm::vec3 target, const Bounds& bounds, const ScreenMap& map) {
    const glm::dvec3 low(bounds.min), high(bounds.max), centre(target);
    const double scene_radius = std::max(glm::length(high - low) / 2, 1e-6);
    // Half the height and half the width of the view, as tangents of angles or (orthographic) as lengths.
    const double half =
        std::min(1 / std::abs(map.clip_from_view[0][0]), 1 / std::abs(map.clip_from_view[1][1]));
    const bool parallel = map.clip_from_view[2][3] == 0;
    const double distance = glm::length(centre - glm::dvec3(map.world_from_view[3]));
    const double fits = parallel ? half : distance * half / std::sqrt(1 + half * half);
    return {centre, std::min(0.86 * fits, 2 * scene_radius)};
}

glm::dvec3 to_world(const Light& light, glm::dvec3 own, double w, const ScreenMap& map) {
    return glm::dvec3(world_from_own(light, map) * glm::dvec4(own, w));
}

glm::dvec3 to_own(const Light& light, glm::dvec3 world, double w, const ScreenMap& map) {
    return glm::dvec3(own_from_world(light, map) * glm::dvec4(world, w));
}

glm::dvec3 direction_of(const Light& light, const ScreenMap& map) {
    return glm::normalize(to_world(light, own_place(light), 0, map));
}

glm::dvec3 handle_of(const Light& light, const Dome& dome, const ScreenMap& map) {
    if (light.kind == LightKind::Directional) return dome.centre + dome.radius * direction_of(light, map);
    return to_world(light, own_place(light), 1, map);
}

Light placed_at(Light light, glm::dvec3 place, const Dome& dome, const ScreenMap& map) {
    if (light.kind == LightKind::Directional) {
        const glm::dvec3 away = place - dome.centre;
        const double length = glm::length(away);
        if (length > 0) light.position = glm::vec4(own_from_world(light, map) * glm::dvec4(away / length, 0));
        return light;
    }
    light.position = glm::vec4(glm::vec3(own_from_world(light, map) * glm::dvec4(place, 1)), 1);
    return light;
}

void turn_shape(Light& light, const glm::dmat4& turn, const ScreenMap& map) {
    const auto turned = [&](glm::vec3 own) {
        const glm::dvec4 world(to_world(light, own, 0, map), 0);
        return glm::vec3(to_own(light, glm::dvec3(turn * world), 0, map));
    };
    if (light.kind == LightKind::Spot) light.spot.direction = turned(light.spot.direction);
    if (light.kind == LightKind::Area) {
        light.area.edge_u = turned(light.area.edge_u);
        light.area.edge_v = turned(light.area.edge_v);
    }
}

Light in_space(Light light, LightSpace space, const Camera& camera) {
    if (light.space == space) return light;
    const ScreenMap map = screen_map(camera, {1, 1});
    const glm::dmat4 to_world = world_from_own(light, map);
    const double w = light.position.w == 0 ? 0 : 1;
    const glm::dvec4 place(own_place(light), w);
    light.space = space;
    const glm::dmat4 carry = own_from_world(light, map) * to_world;
    const auto carried = [&carry](glm::vec3 v) { return glm::vec3(carry * glm::dvec4(v, 0)); };
    light.position = glm::vec4(carry * place);
    light.spot.direction = carried(light.spot.direction);
    light.area.edge_u = carried(light.area.edge_u);
    light.area.edge_v = carried(light.area.edge_v);
    return light;
}

Light as_kind(Light light, LightKind kind, const Dome& dome, const ScreenMap& map) {
    if (light.kind == kind) return light;
    const glm::dvec3 handle = handle_of(light, dome, map);
    light.kind = kind;
    if (kind == LightKind::Directional) light.position.w = 0;
    const bool at_centre = glm::length(handle - dome.centre) < 1e-9;
    return placed_at(light, at_centre ? dome.centre + glm::dvec3(0, 1, 0) : handle, dome, map);
}

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
