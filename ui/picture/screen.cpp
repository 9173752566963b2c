#include "ui/picture/screen.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "renderer/geometry/clip.h"
#include "ui/feature.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"

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

ProjectedPoint project(const ScreenMap& map, glm::dvec3 world) {
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
    // A projection with constant w (orthographic) has parallel lines of sight.
    const bool parallel = map.clip_from_view[2][3] == 0;
    const glm::dvec3 origin = parallel ? unproject(map, pixel, 0) : glm::dvec3(map.world_from_view[3]);
    return {origin, glm::normalize(unproject(map, pixel, 1) - origin)};
}

glm::dvec3 in_world(const ScreenMap& map, glm::vec3 camera, double w) {
    return glm::dvec3(map.world_from_view * glm::dvec4(glm::dvec3(camera), w));
}

bool is_inside(PictureSize size, glm::dvec2 pixel) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.width && pixel.y < size.height;
}

glm::ivec2 nearest_pixel(PictureSize size, glm::dvec2 pixel) {
    return {static_cast<int>(std::clamp(pixel.x, 0.0, size.width - 1.0)),
            static_cast<int>(std::clamp(pixel.y, 0.0, size.height - 1.0))};
}

glm::ivec2 pixel_at_place(glm::ivec2 pixel, PictureSize from, PictureSize to) {
    return {pixel.x * to.width / from.width, pixel.y * to.height / from.height};
}

double PictureView::pixels(float units) const { return double(px(units)) / double(units_per_pixel); }

std::optional<std::pair<ImVec2, ImVec2>> PictureView::shown(glm::dvec3 a, glm::dvec3 b) const {
    constexpr double eye = 1e-3;
    const double depth_a = -(map.view_from_world * glm::dvec4(a, 1)).z;
    const double depth_b = -(map.view_from_world * glm::dvec4(b, 1)).z;
    if (depth_a < eye && depth_b < eye) return {};
    if (depth_a < eye) a += (b - a) * ((eye - depth_a) / (depth_b - depth_a));
    if (depth_b < eye) b += (a - b) * ((eye - depth_b) / (depth_a - depth_b));
    const ProjectedPoint from = project(map, a), to = project(map, b);
    if (!from.in_front || !to.in_front) return {};
    return std::pair(to_window(from.pixel), to_window(to.pixel));
}

void WorldPen::line(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float width) const {
    if (const auto ends = view.shown(a, b)) list.AddLine(ends->first, ends->second, colour, width);
}

void WorldPen::cased(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float opacity, float width) const {
    line(a, b, rim_colour(opacity), px(width + rim_width));
    line(a, b, colour, px(width));
}

void WorldPen::circle(glm::dvec3 centre, glm::dvec3 u, glm::dvec3 v, ImU32 colour, float opacity) const {
    constexpr int sides = 48;
    const auto point = [&](int i) {
        const double a = 2 * std::numbers::pi * i / sides;
        return centre + std::cos(a) * u + std::sin(a) * v;
    };
    for (int i = 0; i < sides; ++i) cased(point(i), point(i + 1), colour, opacity);
}

void WorldPen::mark(glm::dvec3 place, ImU32 colour, float opacity, bool hovered) const {
    const ProjectedPoint at = project(view.map, place);
    if (!at.in_front) return;
    const float radius = hovered ? 5.5f : 3.5f;
    rimmed_disc(list, view.to_window(at.pixel), radius, colour, opacity);
    if (hovered)
        list.AddCircle(view.to_window(at.pixel), px(radius + 1.2f), to_u32({1, 1, 1, 1}, opacity), 0,
                       px(1.5f));
}

namespace {

/// Returns the first scene shown by one of these features; previews count only if `previews` is true.
std::optional<OtherScene> first_shown(std::span<const Feature* const> from, const UiState& state,
                                      bool previews) {
    for (const Feature* feature : from)
        if (feature->shows != nullptr)
            if (std::optional<OtherScene> shown = feature->shows(state);
                shown && (previews || !shown->passes)) {
                shown->by = feature;
                return shown;
            }
    return {};
}

std::size_t place_of(const Feature& feature) {
    return static_cast<std::size_t>(std::find(features().begin(), features().end(), &feature) -
                                    features().begin());
}

/// Returns the pixel to explain: the picked one or the one under the cursor; nullopt if there is none.
std::optional<glm::ivec2> asked_pixel(const UiState& state, const PictureView& view) {
    const PictureSize size = view.map.size;
    if (!asks_at_cursor(state)) return probe_pixel(state.viewport, size);
    return nearest_pixel(size, view.to_pixel(ImGui::GetIO().MousePos));
}

}  // namespace

void decide_shown(OnScreen& shown, const UiState& state) {
    shown.resting = first_shown(features(), state, true);
    shown.passing.reset();
    if (!shown.resting || !shown.resting->passes) return;
    shown.passing = std::move(shown.resting);
    shown.resting = first_shown(features(), state, false);
}

std::optional<OtherScene> resting_below(const UiState& state, const Feature& feature) {
    return first_shown(features().subspan(place_of(feature) + 1), state, false);
}

bool has_turn(const UiState& state, const Feature& feature) {
    return !first_shown(features().first(place_of(feature)), state, true);
}

const Scene& shown_scene(const UiState& state) {
    return state.on_screen.resting ? state.on_screen.resting->scene : state.editor.scene();
}

const Scene& explained_scene(const UiState& state) {
    return state.on_screen.explained_other ? state.on_screen.explained_other->scene : state.editor.scene();
}

Scene* editable_scene(UiState& state) {
    return state.on_screen.explained_other ? nullptr : &state.editor.scene();
}

bool is_explained(const UiState& state) {
    const OnScreen& shown = state.on_screen;
    return shown.explanation && !shown.explained_other &&
           item_counts(state.edited_drawn) == item_counts(state.editor.scene());
}

void explain_picked(UiState& state, const PictureView& view) {
    OnScreen& shown = state.on_screen;
    shown.explanation.reset();
    shown.explained_by = nullptr;
    shown.explained_other = shown.resting;
    const auto asked = asked_pixel(state, view);
    if (!asked) return;
    const PictureSize whole = view.map.size, drawn = state.rendered->size;
    const glm::ivec2 at = pixel_at_place(*asked, whole, drawn);
    shown.explained_by = state.renderer.get();
    shown.explanation = shown.explained_by->explain(at.x, at.y);
    shown.explanation->spaces.pixel *=
        glm::vec2(whole.width, whole.height) / glm::vec2(drawn.width, drawn.height);
    shown.pixel = *asked;
    shown.explained_size = whole;
    shown.explained_drawn = drawn;
}

bool asks_at_cursor(const UiState& state) {
    return ImGui::GetIO().KeyAlt && state.viewport.hovered && state.viewport.gesture == Gesture::None;
}

}  // namespace glint
