#include "ui/camera_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/hands/camera_views.h"
#include "ui/limits.h"
#include "ui/orbit.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace glint {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Half the height of the view at one unit in front of the eye; the orthographic view's at the target.
double half_height(const Camera& camera) {
    if (const auto* p = std::get_if<Perspective>(&camera.projection))
        return std::tan(p->fov_y_deg / 2 * degree);
    if (const auto* o = std::get_if<Orthographic>(&camera.projection))
        return o->height / 2 / std::max(target_depth(camera), 1e-6);
    const auto& f = std::get<Frustum>(camera.projection);
    return std::abs(f.top - f.bottom) / 2 / f.near;
}

bool frustum_fields(Frustum& f) {
    const Number edge{.initial = 0.05f, .speed = 0.001f, .format = "%.4f"};
    bool edited = false;
    edited |= number_field("Left", f.left, edge,
                           {"Edge of the window on the near plane", "/camera/projection/left"});
    edited |= number_field("Right", f.right, edge,
                           {"Edge of the window on the near plane", "/camera/projection/right"});
    edited |= number_field("Bottom", f.bottom, edge,
                           {"Edge of the window on the near plane", "/camera/projection/bottom"});
    edited |=
        number_field("Top", f.top, edge, {"Edge of the window on the near plane", "/camera/projection/top"});
    return edited;
}

bool projection_fields(Projection& projection) {
    bool edited = false;
    if (auto* p = std::get_if<Perspective>(&projection)) {
        const Number angle{.min = 0.1f,
                           .max = 179,
                           .initial = 45,
                           .speed = 0.2f,
                           .format = "%.1f°",
                           .unit = "°",
                           .shown_max = 179};
        edited |= number_field("Field", p->fov_y_deg, angle,
                               {"Whole vertical angle of the view", "/camera/projection/fov_y_deg"});
    } else if (auto* o = std::get_if<Orthographic>(&projection)) {
        const Number height{.min = 1e-4f, .max = 1e7f, .initial = 4, .speed = 0.01f, .logarithmic = true};
        edited |= number_field("Height", o->height, height,
                               {"Height of the view in scene units", "/camera/projection/height"});
    } else {
        edited |= frustum_fields(std::get<Frustum>(projection));
    }
    const Number depth{.min = 1e-6f, .max = 1e9f, .initial = 0.1f, .speed = 0.01f, .logarithmic = true};
    Number far_depth = depth;
    far_depth.initial = 100;
    std::visit(
        [&](auto& p) {
            edited |= number_field(
                "Near", p.near, depth,
                {"What is nearer to the eye is cut off, scene units", "/camera/projection/near"});
            edited |= number_field(
                "Far", p.far, far_depth,
                {"What is farther from the eye is cut off, scene units", "/camera/projection/far"});
        },
        projection);
    return edited;
}

/// Six buttons that look at the target from a side.
bool look_from(Camera& camera) {
    static constexpr struct {
        const char *label, *keys;
        ViewFrom from;
    } sides[] = {{"Front", "pad 1", ViewFrom::Front},    {"Right", "pad 3", ViewFrom::Right},
                 {"Above", "pad 7", ViewFrom::Top},      {"Behind", "Ctrl+pad 1", ViewFrom::Back},
                 {"Left", "Ctrl+pad 3", ViewFrom::Left}, {"Below", "Ctrl+pad 7", ViewFrom::Bottom}};
    section("Look from");
    const Camera before = camera;
    const float gap = px(3), width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    for (int i = 0; i < 6; ++i) {
        if (i % 3 != 0) ImGui::SameLine(0, gap);
        if (ImGui::Button(sides[i].label, {width, 0})) camera = seen_from(camera, sides[i].from);
        tooltip(sides[i].label, "Looks at the target from there, as far away as now", sides[i].keys);
    }
    return camera != before;
}

}  // namespace

Projection as_projection(const Camera& camera, int kind, PictureSize size) {
    const double half = half_height(camera), aspect = static_cast<double>(size.width) / size.height;
    const float near = near_of(camera.projection), far = far_of(camera.projection);
    if (kind == 0)
        return Perspective{std::clamp(static_cast<float>(2 * std::atan(half) / degree), 0.1f, 179.0f), near,
                           far};
    if (kind == 1) return Orthographic{static_cast<float>(2 * half * target_depth(camera)), near, far};
    const auto top = static_cast<float>(half * near), right = static_cast<float>(half * near * aspect);
    return Frustum{-right, right, -top, top, near, far};
}

bool camera_panel(Camera& camera, PictureSize size) {
    const Camera before = camera;
    const Number place{.speed = 0.02f, .format = "%.2f"};
    bool edited = false;
    edited |=
        vector_field("Eye", camera.eye, place, {0, 0, 5}, {"Where the viewer stands, world", "/camera/eye"});
    edited |= vector_field("Target", camera.target, place, {0, 0, 0},
                           {"What the viewer looks at, world", "/camera/target"});
    edited |=
        vector_field("Up", camera.up, place, {0, 1, 0}, {"What is up in the picture, world", "/camera/up"});
    edited |= look_from(camera);
    section("Projection");
    static const std::array<Option, 3> kinds{
        Option{"Perspective", "perspective", "Lines of sight meet in the eye"},
        Option{"Orthographic", "orthographic", "Lines of sight are parallel"},
        Option{"Frustum", "frustum", "A window on the near plane, maybe off the middle"}};
    const int kind = static_cast<int>(camera.projection.index());
    const int chosen =
        choose("Kind", kind, kinds, {"How the view volume is projected", "/camera/projection/type"});
    if (chosen != kind) {
        camera.projection = as_projection(camera, chosen, size);
        edited = true;
    }
    edited |= projection_fields(camera.projection);
    return edited && keep_valid(camera, before);
}

}  // namespace glint
