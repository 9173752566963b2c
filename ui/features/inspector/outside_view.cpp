#include "ui/features/inspector/outside_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "ui/feature.h"
#include "ui/features/inspector/vectors/arrows.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/orbit.h"
#include "ui/picture/screen.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float grip_units = 11;  // design units: a click within this distance of a light selects it

/// Adds the end points of the drawn parts of the camera and of the world's axes.
void add_drawn(std::vector<glm::dvec3>& places, const Scene& scene, const PictureView& main) {
    const double w = main.map.size.width, h = main.map.size.height, deep = drawn_depth(scene.camera);
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {w, 0}, {w, h}, {0, h}})
        places.push_back(unproject(main.map, corner, deep));
    const double length = axis_length(scene.camera);
    const glm::dvec3 eye(scene.camera.eye);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0);
        axis[i] = length;
        places.push_back(axis);
        places.push_back(eye + length * glm::dvec3(main.map.world_from_view[i]));
    }
}

/// All points that must be in view: eye, target, lights, the drawn parts of the camera, and those parts of
/// objects that are no farther from the target than these. A wide floor would make everything else too small.
std::vector<glm::dvec3> all_places(const Scene& scene, const PictureView& main) {
    const glm::dvec3 target(scene.camera.target);
    std::vector<glm::dvec3> places{target, glm::dvec3(scene.camera.eye)};
    for (const Light& light : scene.lights) places.push_back(handle_of(light, main.dome, main.map));
    add_drawn(places, scene, main);
    double reach = 0;
    for (const glm::dvec3& place : places) reach = std::max(reach, 0.7 * glm::length(place - target));
    for (const glm::dvec3& corner : corners_of(main.bounds)) {
        const double away = glm::length(corner - target);
        places.push_back(away > reach ? target + reach / away * (corner - target) : corner);
    }
    return places;
}

/// The light under the cursor, or -1.
int light_under(const Scene& scene, const PictureView& main, const PictureView& outside, ImVec2 cursor) {
    int found = -1;
    double nearest = double(px(grip_units));
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const ProjectedPoint at = project(outside.map, handle_of(scene.lights[i], main.dome, main.map));
        const double away = glm::length(at.pixel - outside.to_pixel(cursor));
        if (!at.in_front || away > nearest) continue;
        nearest = away;
        found = static_cast<int>(i);
    }
    return found;
}

void use_mouse(OutsideState& state, PictureSize size, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) orbit(state.camera, {io.MouseDelta.x, io.MouseDelta.y}, size);
    if (!hovered || io.MouseWheel == 0) return;
    const glm::vec3 arm = state.camera.eye - state.camera.target;
    const float length = glm::length(arm) * std::pow(0.88f, io.MouseWheel);
    if (length > 1e-3f && length < 1e6f)
        state.camera.eye = state.camera.target + glm::normalize(arm) * length;
}

void legend() {
    wrapped_dim("Drag: turn. Wheel: closer. Double-click: show all. Click a light: select it.");
    wrapped_dim(
        "C lights are attached to the camera, on a line from the eye; W lights stay in the world. Orbit the "
        "picture and watch.");
}

}  // namespace

Camera outside_camera(const Scene& scene, const PictureView& main, PictureSize size) {
    // Sixty degrees to the right of the eye and thirty degrees above it.
    const glm::dvec3 back(main.map.world_from_view[2]), level{back.x, 0, back.z};
    const glm::dvec3 front = glm::length(level) > 1e-6 ? glm::normalize(level) : glm::dvec3(0, 0, 1);
    const glm::dvec3 side = rotated(front, {0, 1, 0}, std::numbers::pi / 3);
    const glm::dvec3 way = glm::normalize(0.866 * side + glm::dvec3(0, 0.5, 0));
    const glm::dvec3 right = glm::normalize(glm::cross({0, 1, 0}, way)), up = glm::cross(way, right);
    const glm::dmat3 seen_from_world = glm::transpose(glm::dmat3(right, up, way));
    std::vector<glm::dvec3> seen;
    for (const glm::dvec3& place : all_places(scene, main)) seen.push_back(seen_from_world * place);
    glm::dvec3 low = seen[0], high = seen[0];
    for (const glm::dvec3& place : seen) low = glm::min(low, place), high = glm::max(high, place);
    const glm::dvec3 middle = (low + high) / 2.0;
    // The camera is as close as the outermost point allows; a tenth of the view is left for the labels next
    // to the marks.
    constexpr double fov_y_deg = 40, used = 0.9;
    const double half_y = used * std::tan(fov_y_deg / 360 * std::numbers::pi);
    const double half_x = half_y * size.width / size.height;
    double distance = 1e-3;
    for (const glm::dvec3& place : seen) {
        const glm::dvec3 off = place - middle;
        distance = std::max(distance, off.z + std::max(std::abs(off.x) / half_x, std::abs(off.y) / half_y));
    }
    Camera camera;
    camera.target = glm::vec3(glm::transpose(seen_from_world) * middle);
    camera.eye = camera.target + glm::vec3(distance * way);
    camera.projection = Perspective{float(fov_y_deg), float(distance * 1e-3), float(distance * 100)};
    return camera;
}

void outside_tab(UiState& state, const PictureView& main) {
    OutsideState& outside = state.get<OutsideState>();
    const Scene& scene = state.editor.scene();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 extent{std::max(room.x, px(60)),
                        std::clamp(room.y - px(90), px(120), 1.15f * std::max(room.x, px(120)))};
    const auto side = [](float length) {
        return static_cast<int>(std::clamp(length, 1.0f, float(max_picture_side)));
    };
    const PictureSize size{side(extent.x), side(extent.y)};
    PictureView view = main;
    view.origin = ImGui::GetCursorScreenPos();
    view.units_per_pixel = 1;
    hit_area("##outside", extent);
    const bool hovered = ImGui::IsItemHovered();
    list_control("Outside view", "", {view.origin, ImGui::GetItemRectMax()});
    const bool reset = hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (!outside.placed || reset) outside = {outside_camera(scene, main, size), true};
    use_mouse(outside, size, hovered);
    view.map = screen_map(outside.camera, size);
    const int light = hovered ? light_under(scene, main, view, ImGui::GetIO().MousePos) : -1;
    if (light >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (light >= 0 && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
        ImGui::GetIO().MouseDragMaxDistanceSqr[0] < 16)
        state.editor.selection = {Selection::Kind::Light, light};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high = view.origin + extent;
    list.AddRectFilled(view.origin, high, to_u32(theme().surround), px(4));
    list.PushClipRect(view.origin, high, true);
    draw_outside(list, view, {scene, main, selected_light(state.editor.selection), light});
    list.PopClipRect();
    legend();
}

extern const Feature outside_feature;
const Feature outside_feature{
    .leave_document = [](UiState& s, const SceneDocument&) { s.get<OutsideState>().placed = false; }};

namespace {

constexpr std::size_t max_lines = 6000;  // lines of all meshes together
const ImVec4 ink{0.06f, 0.06f, 0.07f, 1};

/// The label of a mark. `way`: the preferred side of the mark, zero or a unit vector.
struct Label {
    ImVec2 mark, way;
    std::string words;
    ImU32 colour;
};

/// A pen that also draws labels, after all lines are known, so that no label covers another label or a line.
struct LabelledPen : WorldPen {
    LabelRoom& room;
    std::vector<Label>& labels;

    /// Adds a label to the right of a window position, or on the side given by `way`.
    void text(ImVec2 mark, const std::string& words, ImU32 colour, ImVec2 way = {1, 0}) const {
        labels.push_back({mark, way, words, colour});
    }
    /// Keeps labels off a mark.
    void keep_free(ImVec2 mark, float radius) const {
        const ImVec2 half = px(radius) * ImVec2(1, 1);
        room.keep_free({mark - half, mark + half});
    }
    /// Draws a label; if it is displaced, a line connects it to its mark.
    void write(const Label& label) const {
        const ImVec2 size = ImGui::CalcTextSize(label.words.c_str()), more{px(2), 0};
        const ImVec2 away{px(5) + size.x / 2, px(2) + size.y / 2};
        const ImVec2 wanted = label.mark + ImVec2(label.way.x * away.x, label.way.y * away.y);
        const ImVec2 middle = room.place_anyhow(wanted, size + 2 * more, px(72));
        const ImVec2 low = middle - size / 2, high = middle + size / 2;
        if (length_of(middle - wanted) > size.y)
            list.AddLine(label.mark, {std::clamp(label.mark.x, low.x, high.x), middle.y}, label.colour,
                         px(1));
        list.AddRectFilled(low - more, high + more, to_u32(theme().surround, 0.85f), px(3));
        list.AddText(low, label.colour, label.words.c_str());
        list_control("Label of the outside view", label.words, {low, high});
    }
};

/// The opacity of an object's lines. It is low for an object that is large compared to the camera's distance
/// from its target, such as a floor, because the objects on the floor matter more.
float mesh_opacity(const Object& object, double reach) {
    const glm::dmat3 world(world_from_object(object.transform));
    const glm::dvec3 edges = glm::dvec3(object.mesh->bounds.max) - glm::dvec3(object.mesh->bounds.min);
    const double size = glm::length(world * edges);
    return 0.34f * float(std::clamp(reach / std::max(size, 1e-9), 0.15, 1.0));
}

void draw_mesh(const WorldPen& pen, const Object& object, std::size_t lines, double reach) {
    if (!object.mesh || !object.visible || object.mesh->triangles.empty()) return;
    const Mesh& mesh = *object.mesh;
    const glm::dmat4 world = world_from_object(object.transform);
    const std::size_t step =
        std::max<std::size_t>(1, mesh.triangles.size() / std::max<std::size_t>(lines / 2, 1));
    const auto place = [&](std::uint32_t corner) {
        return glm::dvec3(world * glm::dvec4(glm::dvec3(mesh.positions[mesh.corner_position[corner]]), 1));
    };
    const ImU32 colour = to_u32(ink, mesh_opacity(object, reach));
    for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
        const auto& corner = mesh.triangles[i].corner;
        pen.line(place(corner[0]), place(corner[1]), colour, px(1));
        pen.line(place(corner[1]), place(corner[2]), colour, px(1));
    }
}

void draw_axes(const LabelledPen& pen, const glm::dmat4& frame, double length,
               const char* const (&names)[3]) {
    const std::array colours{ImVec4{0.75f, 0.15f, 0.1f, 1}, ImVec4{0.1f, 0.5f, 0.1f, 1},
                             ImVec4{0.1f, 0.25f, 0.8f, 1}};
    const glm::dvec3 origin(frame[3]);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 end = origin + length * glm::dvec3(frame[i]);
        const ImU32 colour = to_u32(colours[std::size_t(i)]);
        pen.line(origin, end, colour, px(2));
        const ProjectedPoint from = project(pen.view.map, origin), to = project(pen.view.map, end);
        if (!from.in_front || !to.in_front) continue;
        const ImVec2 tip = pen.view.to_window(to.pixel), way = tip - pen.view.to_window(from.pixel);
        const float length_px = length_of(way);
        pen.text(tip, names[i], colour, length_px > 1 ? way / length_px : ImVec2(1, 0));
    }
}

/// Draws the eye and its view volume.
void draw_camera(const LabelledPen& pen, const OutsideScene& what, double size) {
    const ScreenMap& map = what.main.map;
    const Camera& camera = what.scene.camera;
    const double w = map.size.width, h = map.size.height;
    const std::array<glm::dvec2, 4> corners{{{0, 0}, {w, 0}, {w, h}, {0, h}}};
    const double near = double(near_of(camera.projection));
    const double depths[] = {near, target_depth(camera), drawn_depth(camera)};
    const ImU32 strong = to_u32(ink), weak = to_u32(ink, 0.55f);
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 4; ++i)
            pen.line(unproject(map, corners[i], depths[k]), unproject(map, corners[(i + 1) % 4], depths[k]),
                     k == 0 ? strong : weak, px(k == 1 ? 1 : 1.5f));
    const glm::dvec3 eye(camera.eye);
    const bool parallel = is_orthographic(camera.projection);
    for (const glm::dvec2& corner : corners)
        pen.line(parallel ? unproject(map, corner, 0) : eye, unproject(map, corner, depths[2]), weak,
                 px(1.2f));
    pen.line(eye, glm::dvec3(camera.target), to_u32(ink, 0.3f), px(1));
    pen.mark(eye, to_u32({1, 1, 1, 1}), 1, false);
    if (const ProjectedPoint at = project(pen.view.map, eye); at.in_front)
        pen.text(pen.view.to_window(at.pixel) + ImVec2(0, px(5)), "eye", strong, {0, 1});
    draw_axes(pen, map.world_from_view, size, {"x", "y", "z"});
}

/// Keeps labels off a light's mark.
void keep_light_free(const LabelledPen& pen, const OutsideScene& what, std::size_t index) {
    const ProjectedPoint at =
        project(pen.view.map, handle_of(what.scene.lights[index], what.main.dome, what.main.map));
    if (!at.in_front) return;
    pen.keep_free(pen.view.to_window(at.pixel), 8);
}

void draw_light(const LabelledPen& pen, const OutsideScene& what, int index) {
    const Light& light = what.scene.lights[std::size_t(index)];
    const glm::dvec3 place = handle_of(light, what.main.dome, what.main.map);
    const bool rides = light.space == LightSpace::Camera;
    const ImU32 colour = to_u32(colour_of(light), light.enabled ? 1 : 0.5f);
    if (rides) pen.cased(glm::dvec3(what.scene.camera.eye), place, colour, 0.8f);
    if (light.kind == LightKind::Directional)
        pen.cased(place, place - 0.35 * what.main.dome.radius * direction_of(light, what.main.map), colour,
                  1);
    const ProjectedPoint at = project(pen.view.map, place);
    if (!at.in_front) return;
    const ImVec2 p = pen.view.to_window(at.pixel);
    const float radius = index == what.hovered_light ? 7.5f : 6;
    draw_light_disc(pen.list, p, radius, light, colour, 1);
    if (index == what.selected_light) pen.list.AddCircle(p, px(radius + 4), to_u32(theme().accent), 0, px(2));
    const std::string label = light.name + (rides ? "  C" : "  W");
    pen.text(p + ImVec2(px(8), 0), label.c_str(), to_u32(ink));
}

}  // namespace

double drawn_depth(const Camera& camera) {
    return std::min(1.35 * target_depth(camera), double(far_of(camera.projection)));
}

double axis_length(const Camera& camera) { return 0.22 * target_depth(camera); }

void draw_outside(ImDrawList& list, const PictureView& view, const OutsideScene& what) {
    constexpr std::size_t max_items = 300;  // at most this many lights, and this many objects
    const PictureSize size_px = view.map.size;
    LabelRoom room({view.to_window({3, 2}), view.to_window({size_px.width - 3, size_px.height - 2})});
    std::vector<Label> labels;
    const LabelledPen pen{{list, view}, room, labels};
    const auto lights = std::min(what.scene.lights.size(), max_items);
    for (std::size_t i = 0; i < lights; ++i) keep_light_free(pen, what, i);
    const auto objects = std::min(what.scene.objects.size(), max_items);
    if (const ProjectedPoint eye = project(view.map, glm::dvec3(what.scene.camera.eye)); eye.in_front)
        pen.keep_free(view.to_window(eye.pixel), 6);
    const double reach = target_depth(what.scene.camera);
    for (std::size_t i = 0; i < objects; ++i)
        draw_mesh(pen, what.scene.objects[i], max_lines / objects, reach);
    const double size = axis_length(what.scene.camera);
    for (std::size_t i = 0; i < lights; ++i) draw_light(pen, what, static_cast<int>(i));
    draw_camera(pen, what, size);
    draw_axes(pen, glm::dmat4(1), size, {"X", "Y", "Z"});
    ImGui::PushFont(fonts().small);
    for (const Label& label : labels) pen.write(label);
    ImGui::PopFont();
}

}  // namespace glint
