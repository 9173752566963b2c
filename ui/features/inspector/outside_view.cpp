#include "ui/features/inspector/outside_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "ui/feature.h"
#include "ui/picture/handles/drag_math.h"
#include "ui/picture/handles/light_place.h"
#include "ui/picture/orbit.h"
#include "ui/ui.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
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

}  // namespace glint
