#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "ui/features/inspector/label_room.h"
#include "ui/features/inspector/outside_view.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/orbit.h"
#include "ui/picture/screen.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"

namespace glint {
namespace {

constexpr std::size_t max_lines = 6000;  // of all meshes together
const ImVec4 ink{0.06f, 0.06f, 0.07f, 1};

/// The label of a mark. `way`: its preferred side of the mark (0, or unit).
struct Label {
    ImVec2 mark, way;
    std::string words;
    ImU32 colour;
};

/// A pen that also draws labels, after all lines are known, so that no label covers another label or a line.
struct LabelledPen : WorldPen {
    LabelRoom& room;
    std::vector<Label>& labels;

    /// To the right of a window position, or on the side given by `way`.
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

/// Draws the lines of an object fainter if it is large compared to the camera's distance from its target,
/// such as a floor: the objects on it matter more.
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
    constexpr std::size_t max_items = 300;  // of lights, and of objects
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
