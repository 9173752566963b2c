#include "ui/picture/orbit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <utility>

#include "models/fields/scene_fields.h"
#include "models/numbers.h"
#include "models/scene/scene.h"
#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/screen.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double closest = 1e-4, farthest = max_number / 10;  // eye to target, scene units
constexpr double closest_share = 1e-4;  // of the largest coordinate; any closer, and rounding turns the view
constexpr double pole_margin = std::numbers::pi / 180;

bool usable(const Camera& camera) {
    const glm::vec3 reach = glm::max(glm::abs(camera.eye), glm::abs(camera.target));
    const double away = std::max({double(reach.x), double(reach.y), double(reach.z)});
    const double distance = target_depth(camera);
    return distance > std::max(closest, closest_share * away) && distance < farthest && away < max_number &&
           !violation_of(camera);
}

/// Returns the depths of the nearest and farthest corners of a box in front of a camera.
std::pair<double, double> depths_of(const Camera& camera, const Bounds& bounds) {
    const glm::dmat4 view = view_from_world(camera);
    double low = 1e300, high = -1e300;
    for (const glm::dvec3& corner : corners_of(bounds)) {
        const double depth = -(view * glm::dvec4(corner, 1)).z;
        low = std::min(low, depth);
        high = std::max(high, depth);
    }
    return {low, high};
}

/// Moves the eye and the target by the same vector.
Camera shifted(Camera camera, glm::dvec3 shift) {
    camera.eye = glm::vec3(glm::dvec3(camera.eye) + shift);
    camera.target = glm::vec3(glm::dvec3(camera.target) + shift);
    return camera;
}

/// Returns points of the visible objects, or of the one with that index, in camera coordinates; for large
/// meshes, only some of the points.
std::vector<glm::dvec3> framed_points(const Scene& scene, int object, const glm::dmat4& view_from_world) {
    constexpr std::size_t enough = 50'000;  // points of a mesh
    std::vector<glm::dvec3> points;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Object& each = scene.objects[o];
        if (!each.mesh || (object >= 0 ? static_cast<int>(o) != object : !each.visible)) continue;
        const glm::dmat4 to_view = view_from_world * world_from_object(each.transform);
        const std::vector<glm::vec3>& positions = each.mesh->positions;
        for (std::size_t p = 0; p < positions.size(); p += positions.size() / enough + 1)
            points.emplace_back(to_view * glm::dvec4(positions[p], 1));
    }
    return points;
}

/// Along one axis of the picture, a point at x to the side and d in front of the eye is in the required part
/// of the picture if d low <= x <= d high. If the eye is moved sideways by s and forward by f, the condition
/// for all points is left <= low f - s and right <= s - high f.
struct Extent {
    double low = 0, high = 0, left = -HUGE_VAL, right = -HUGE_VAL;
    /// The largest forward motion of the eye.
    [[nodiscard]] double forward() const { return -size() / (high - low); }
    /// The sideways motion that leaves equal margins on both sides.
    [[nodiscard]] double middle(double forward) const { return (right - left + (low + high) * forward) / 2; }
    [[nodiscard]] double size() const { return left + right; }
};

Extent extent_along(int axis, const std::vector<glm::dvec3>& points, const ScreenMap& map, double share) {
    Extent extent;
    if (map.clip_from_view[2][3] != 0) {  // perspective
        const double scale = map.clip_from_view[axis][axis], shift = map.clip_from_view[2][axis];
        extent.low = (shift - share) / scale, extent.high = (shift + share) / scale;
    }
    for (const glm::dvec3& at : points) {
        extent.right = std::max(extent.right, at[axis] + extent.high * at.z);
        extent.left = std::max(extent.left, -at[axis] - extent.low * at.z);
    }
    return extent;
}

glm::dvec3 way_to_eye(ViewFrom from) {
    constexpr double off_pole = 2e-3;  // a tenth of a degree
    switch (from) {
    case ViewFrom::Front:
        return {0, 0, 1};
    case ViewFrom::Back:
        return {0, 0, -1};
    case ViewFrom::Right:
        return {1, 0, 0};
    case ViewFrom::Left:
        return {-1, 0, 0};
    case ViewFrom::Top:
        return {0, 1, off_pole};
    case ViewFrom::Bottom:
        return {0, -1, off_pole};
    }
    return {0, 0, 1};  // not reached
}

}  // namespace

double target_depth(const Camera& camera) {
    return glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
}

void orbit(Camera& camera, glm::dvec2 motion_px, PictureSize size) {
    const double turn = 2 * std::numbers::pi / size.height;
    const glm::dvec3 up = glm::normalize(glm::dvec3(camera.up));
    const glm::dvec3 arm = glm::dvec3(camera.eye) - glm::dvec3(camera.target);
    const double radius = glm::length(arm);
    const double from_pole = std::acos(std::clamp(glm::dot(arm, up) / radius, -1.0, 1.0));
    const glm::dvec3 level = glm::normalize(arm - glm::dot(arm, up) * up), side = glm::cross(up, level);
    const double yaw = -motion_px.x * turn;
    const double polar =
        std::clamp(from_pole - motion_px.y * turn, pole_margin, std::numbers::pi - pole_margin);
    const glm::dvec3 outward = std::cos(yaw) * level + std::sin(yaw) * side;
    Camera turned = camera;
    turned.eye =
        glm::vec3(glm::dvec3(camera.target) + radius * (std::cos(polar) * up + std::sin(polar) * outward));
    if (!violation_of(turned)) camera = turned;
}

void pan(Camera& camera, glm::dvec2 from_px, glm::dvec2 to_px, double depth, PictureSize size) {
    const ScreenMap map = screen_map(camera, size);
    const Camera moved = shifted(camera, unproject(map, from_px, depth) - unproject(map, to_px, depth));
    if (usable(moved) || !usable(camera)) camera = moved;
}

void dolly(Camera& camera, glm::dvec2 cursor_px, double depth, double factor, PictureSize size) {
    const ScreenMap map = screen_map(camera, size);
    const glm::dvec3 anchor = unproject(map, cursor_px, depth);
    Camera moved = camera;
    if (auto* flat = std::get_if<Orthographic>(&moved.projection)) {
        const double height = flat->height * factor;
        if (factor < 1 ? height < closest : height > farthest) return;
        flat->height = static_cast<float>(height);
        moved = shifted(moved, anchor - unproject(screen_map(moved, size), cursor_px, depth));
    } else {
        moved.eye = glm::vec3(anchor + factor * (glm::dvec3(camera.eye) - anchor));
        moved.target = glm::vec3(anchor + factor * (glm::dvec3(camera.target) - anchor));
    }
    if (usable(moved) || !usable(camera)) camera = moved;
}

void fill_picture(Scene& scene, int object, PictureSize size) {
    constexpr double share = 0.8;
    Camera camera = scene.camera;
    const ScreenMap map = screen_map(camera, size);
    const std::vector<glm::dvec3> seen = framed_points(scene, object, map.view_from_world);
    if (seen.empty()) return;
    const bool is_parallel = is_orthographic(camera.projection);
    const Extent x = extent_along(0, seen, map, share), y = extent_along(1, seen, map, share);
    const double forward = is_parallel ? 0 : std::min(x.forward(), y.forward());
    const auto [far, near] =
        std::minmax_element(seen.begin(), seen.end(), [](auto& a, auto& b) { return a.z < b.z; });
    const auto in_world = [&](double z) {
        return glm::vec3(map.world_from_view * glm::dvec4(x.middle(forward), y.middle(forward), z, 1));
    };
    camera.eye = in_world(-forward), camera.target = in_world((near->z + far->z) / 2);
    if (auto* flat = std::get_if<Orthographic>(&camera.projection))
        flat->height *= static_cast<float>(
            std::max(x.size() * map.clip_from_view[0][0], y.size() * map.clip_from_view[1][1]) / 2 / share);
    if (!usable(camera)) return;
    Bounds framed{glm::vec3(HUGE_VALF), glm::vec3(-HUGE_VALF)};
    for (const glm::dvec3& point : seen) {
        const glm::vec3 at(map.world_from_view * glm::dvec4(point, 1));
        framed = {glm::min(framed.min, at), glm::max(framed.max, at)};
    }
    keep_depth_range(camera, scene.camera, scene_bounds(scene));
    keep_depth_range(camera, scene.camera, framed);  // even if the scene extends behind the eye
    scene.camera = camera;
}

void keep_depth_range(Camera& camera, const Camera& before, const Bounds& bounds) {
    const auto [low_before, high_before] = depths_of(before, bounds);
    if (low_before < near_of(before.projection) || high_before > far_of(before.projection)) return;
    const auto [low, high] = depths_of(camera, bounds);
    std::visit(
        [low = low, high = high](auto& p) {
            [[maybe_unused]] const float near_before = p.near;
            if (high > p.far) p.far = static_cast<float>(std::min(high * 1.5, max_number));
            // A near plane at the eye would waste all depth precision; one that is already closer does not
            // change.
            if (low < p.near) p.near = std::min(p.near, static_cast<float>(std::max(low / 2, p.far * 1e-4)));
            // The window of a frustum is on its near plane. It shrinks with the plane; otherwise the angle
            // would change.
            if constexpr (requires { p.left; }) {
                const float share = p.near / near_before;
                p.left *= share, p.right *= share, p.bottom *= share, p.top *= share;
            }
        },
        camera.projection);
}

Camera seen_from(Camera camera, ViewFrom from) {
    const Camera before = camera;
    const glm::dvec3 way = glm::normalize(way_to_eye(from));
    camera.eye = glm::vec3(glm::dvec3(camera.target) + target_depth(camera) * way);
    camera.up = {0, 1, 0};
    return violation_of(camera) ? before : camera;
}

Camera other_projection(Camera camera, PictureSize size) {
    camera.projection = as_projection(
        camera,
        is_orthographic(camera.projection) ? ProjectionKind::Perspective : ProjectionKind::Orthographic,
        size);
    return camera;
}

// Orientation in the scene: clickable axes in the corner of the picture, and a grid on the ground.

namespace {

struct OrientationState {
    bool axes = true, grid = false;
    int hovered = -1;  // index in `ends`
    float below = 0;   // height of a comparison's labels, below which the axes are drawn
};

/// One end of an axis, and the view from that end.
struct AxisEnd {
    glm::dvec3 way;
    const char* name;
    ViewFrom from;
    CommandId key;
};
constexpr std::array<AxisEnd, 6> ends{{{{1, 0, 0}, "x", ViewFrom::Right, CommandId::ViewRight},
                                       {{-1, 0, 0}, "", ViewFrom::Left, CommandId::ViewLeft},
                                       {{0, 1, 0}, "y", ViewFrom::Top, CommandId::ViewTop},
                                       {{0, -1, 0}, "", ViewFrom::Bottom, CommandId::ViewBottom},
                                       {{0, 0, 1}, "z", ViewFrom::Front, CommandId::ViewFront},
                                       {{0, 0, -1}, "", ViewFrom::Back, CommandId::ViewBack}}};
constexpr float arm = 26, end_radius = 8, margin = 46;  // logical pixels

/// Whether the visible part of the picture is large enough for the axes.
bool has_room(const Rect& picture) { return std::min(picture.size().x, picture.size().y) >= px(240); }

ImVec2 middle_of_axes(const UiState& state) {
    const Rect picture = picture_in_sight(state);
    return {picture.high.x - px(margin), picture.low.y + px(margin) + state.get<OrientationState>().below};
}

ImVec2 place_of(const AxisEnd& end, ImVec2 middle, const ScreenMap& map) {
    const glm::dvec3 in_view(map.view_from_world * glm::dvec4(end.way, 0));
    return middle + px(arm) * ImVec2(float(in_view.x), float(-in_view.y));
}

double depth_of(const AxisEnd& end, const ScreenMap& map) {
    return -glm::dvec3(map.view_from_world * glm::dvec4(end.way, 0)).z;
}

bool is_shown(const UiState& state) {
    return state.get<OrientationState>().axes && has_room(picture_in_sight(state)) && !is_held(state) &&
           !state.layout.hides_all && state.on_screen.refusal().empty();
}

bool hover_axes(ToolFrame& frame) {
    OrientationState& orientation = frame.state.get<OrientationState>();
    orientation.hovered = -1;
    if (!frame.over || !is_shown(frame.state)) return false;
    const ImVec2 mouse = ImGui::GetIO().MousePos, middle = middle_of_axes(frame.state);
    for (int i = 0; i < static_cast<int>(ends.size()); ++i) {
        const AxisEnd& end = ends[static_cast<std::size_t>(i)];
        const ImVec2 away = mouse - place_of(end, middle, frame.view.map);
        const bool is_nearer =
            orientation.hovered < 0 ||
            depth_of(end, frame.view.map) <
                depth_of(ends[static_cast<std::size_t>(orientation.hovered)], frame.view.map);
        if (length_of(away) <= px(12) && is_nearer) orientation.hovered = i;
    }
    if (orientation.hovered >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return orientation.hovered >= 0;
}

int press_axes(ToolFrame& frame) {
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return not_taken;
    run_command(frame.state, ends[static_cast<std::size_t>(frame.state.get<OrientationState>().hovered)].key);
    return not_taken;
}

std::string axes_hint(const UiState& state) {
    const int hovered = state.get<OrientationState>().hovered;
    if (hovered < 0) return {};
    const CommandId id = ends[static_cast<std::size_t>(hovered)].key;
    return std::string("Click: ") + command(id).name + " (" + keys_of(id) + ")";
}

const Tool axes_tool{.hover = hover_axes, .press = press_axes, .hint = axes_hint};

void draw_axes(ImDrawList& list, const UiState& state, const PictureView& view) {
    static constexpr std::array<ImU32, 3> colours{IM_COL32(235, 92, 92, 255), IM_COL32(120, 200, 90, 255),
                                                  IM_COL32(92, 150, 245, 255)};
    const ImVec2 middle = middle_of_axes(state);
    std::array<int, 6> order{0, 1, 2, 3, 4, 5};  // farthest first
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return depth_of(ends[static_cast<std::size_t>(a)], view.map) >
               depth_of(ends[static_cast<std::size_t>(b)], view.map);
    });
    for (const int i : order) {
        const AxisEnd& end = ends[static_cast<std::size_t>(i)];
        const ImU32 colour = colours[static_cast<std::size_t>(i / 2)];
        const ImVec2 at = place_of(end, middle, view.map);
        const bool lit = state.get<OrientationState>().hovered == i, named = *end.name != 0;
        if (named) cased_line(list, middle, at, colour, 1.6f);
        rimmed_disc(list, at, named || lit ? end_radius : 4, colour, named || lit ? 1.0f : 0.55f);
        const ImVec2 size = ImGui::CalcTextSize(end.name);
        if (named) list.AddText(at - size / 2, IM_COL32(15, 15, 15, 255), end.name);
        const ImVec2 reach = px(1) * ImVec2(12, 12);
        list_control(command(end.key).name, "axis", {at - reach, at + reach});
    }
}

/// Returns the distance between lines: 1, 2 or 5 times a power of ten, at least a twelfth of the scene's
/// width.
double grid_step(double width) {
    const double least = width / 12, ten = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * ten >= least) return factor * ten;
    return 10 * ten;
}

/// Draws lines at ground_height(), hidden where a surface is in front of them.
void draw_grid(ImDrawList& list, const UiState& state, const PictureView& view) {
    constexpr int lines = 12, pieces = 48;  // lines on either side of the centre; segments per line
    const Bounds& bounds = view.bounds;
    const glm::dvec3 low(bounds.min), high(bounds.max);
    const double step = grid_step(std::max({high.x - low.x, high.z - low.z, 1e-6}));
    const glm::dvec2 middle{std::round((low.x + high.x) / 2 / step) * step,
                            std::round((low.z + high.z) / 2 / step) * step};
    const double ground = ground_height(state.editor.scene());
    const Renderer* const renderer = renderer_of_open_scene(state, view.map.size);
    const auto is_hidden = [&](const ProjectedPoint& at) {
        if (renderer == nullptr || !is_inside(view.map.size, at.pixel)) return false;
        const double depth = renderer->depth_at(int(at.pixel.x), int(at.pixel.y));
        return depth > 0 && depth < at.depth * 0.995;
    };
    for (int axis = 0; axis < 2; ++axis)
        for (int line = -lines; line <= lines; ++line)
            for (int piece = 0; piece < pieces; ++piece) {
                const auto at = [&](double along) {
                    const double a = (2 * along / pieces - 1) * lines * step, b = line * step;
                    return project(view.map,
                                   {middle.x + (axis == 0 ? a : b), ground, middle.y + (axis == 0 ? b : a)});
                };
                const ProjectedPoint from = at(piece), to = at(piece + 1), half = at(piece + 0.5);
                if (!from.in_front || !to.in_front || is_hidden(half)) continue;
                list.AddLine(view.to_window(from.pixel), view.to_window(to.pixel),
                             IM_COL32(255, 255, 255, line == 0 ? 130 : 60), px(1));
            }
}

void draw_orientation(ImDrawList& list, UiState& state, const PictureView& view) {
    if (state.get<OrientationState>().grid) draw_grid(list, state, view);
    if (is_shown(state)) draw_axes(list, state, view);
}

template <bool OrientationState::*shown> WindowCommand toggle(const char* name, const char* words) {
    return {.name = name,
            .section = Section::ViewWindow,
            .run = [](UiState& s) { s.get<OrientationState>().*shown ^= true; },
            .is_on = [](const UiState& s) { return s.get<OrientationState>().*shown; },
            .quiet = true,
            .words = words};
}

}  // namespace

extern const Feature orientation_feature;
const Feature orientation_feature{
    .begin = [](UiState& s, const UiInput&) { s.get<OrientationState>().below = s.label_height; },
    .tool = &axes_tool,
    .overlay = draw_orientation,
    .commands =
        [] {
            return std::vector<WindowCommand>{
                toggle<&OrientationState::axes>("Axes in the corner", "gizmo view cube orientation"),
                toggle<&OrientationState::grid>("Ground grid", "floor lines")};
        },
    .write_settings = [](const UiState& s, Json& json) { json["axes"] = s.get<OrientationState>().axes; },
    .read_settings =
        [](UiState& s, const Json& json) {
            s.get<OrientationState>() = {};
            read_member(json, "axes", s.get<OrientationState>().axes);
        }};

}  // namespace glint
