// The panels of the items that a scene has exactly one of: camera, shading, display.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "models/numbers.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/picture/orbit.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

/// Returns half the height of the view, one unit in front of the eye or, for an orthographic view, at the
/// target.
double half_height(const Camera& camera) {
    if (const auto* p = std::get_if<Perspective>(&camera.projection))
        return std::tan(p->fov_y_deg / 2 * degree);
    if (const auto* o = std::get_if<Orthographic>(&camera.projection))
        return o->height / 2 / std::max(target_depth(camera), 1e-6);
    const auto& f = std::get<Frustum>(camera.projection);
    return std::abs(f.top - f.bottom) / 2 / f.near;
}

/// Draws six buttons, each for a view of the target from one side.
void look_from(Camera& camera) {
    static constexpr struct {
        const char* label;
        CommandId command;
        ViewFrom from;
    } sides[] = {
        {"Front", CommandId::ViewFront, ViewFrom::Front}, {"Right", CommandId::ViewRight, ViewFrom::Right},
        {"Above", CommandId::ViewTop, ViewFrom::Top},     {"Behind", CommandId::ViewBack, ViewFrom::Back},
        {"Left", CommandId::ViewLeft, ViewFrom::Left},    {"Below", CommandId::ViewBottom, ViewFrom::Bottom}};
    section_heading("Look from");
    const float gap = px(3), width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    for (int i = 0; i < 6; ++i) {
        if (i % 3 != 0) ImGui::SameLine(0, gap);
        if (ImGui::Button(sides[i].label, {width, 0})) camera = seen_from(camera, sides[i].from);
        tooltip(sides[i].label, "Views the target from this side, at the same distance", "",
                keys_of(sides[i].command));
    }
}

}  // namespace

void note_fitted(const Camera& camera, PictureSize size) {
    const Projection drawn = fitted(camera.projection, size);
    if (drawn == camera.projection) return;
    if (const auto* p = std::get_if<Perspective>(&drawn))
        wrapped_dim(fmt::format(
            "Drawn with {:.1f}° to keep the view's width, because the picture is narrower than 16:9",
            p->fov_y_deg));
    else if (const auto* o = std::get_if<Orthographic>(&drawn))
        wrapped_dim(fmt::format(
            "Drawn {:.3g} high to keep the view's width, because the picture is narrower than 16:9",
            o->height));
}

Projection as_projection(const Camera& camera, ProjectionKind kind, PictureSize size) {
    // A frustum is not widened for a narrow picture, so switching to or from it converts the visible region.
    const bool is_frustum = kind == ProjectionKind::Frustum;
    const bool was_frustum = kind_of(camera.projection) == ProjectionKind::Frustum;
    const double aspect = static_cast<double>(size.width) / size.height;
    Camera shown = camera;
    if (is_frustum) shown.projection = fitted(camera.projection, size);
    const bool will_be_widened = was_frustum && !is_frustum && is_widened(size);
    const double half = half_height(shown) * (will_be_widened ? aspect / composed_aspect : 1);
    const float near = near_of(camera.projection), far = far_of(camera.projection);
    if (kind == ProjectionKind::Perspective)
        return Perspective{std::clamp(static_cast<float>(2 * std::atan(half) / degree), 0.1f, 179.0f), near,
                           far};
    if (kind == ProjectionKind::Orthographic)
        return Orthographic{static_cast<float>(2 * half * target_depth(camera)), near, far};
    const auto top = static_cast<float>(half * near), right = static_cast<float>(half * near * aspect);
    return Frustum{-right, right, -top, top, near, far};
}

namespace {

/// Draws the fields of the projection with the values in effect: a narrow picture shows more above and below
/// than the stored values say.
void projection_fields(Projection& written, PictureSize size) {
    Projection drawn = fitted(written, size);
    const Projection before = drawn;
    std::visit([](auto& projection) { field_rows(projection, "/camera/projection"); }, drawn);
    if (before == written) {
        written = drawn;
        return;
    }
    const bool edited = !(drawn == before);
    const double share =
        double(size.width) / size.height / composed_aspect;  // as a fraction of the drawn height
    if (auto* p = std::get_if<Perspective>(&drawn)) {
        const double half = std::tan(p->fov_y_deg / 2 * degree) * share;
        const auto in_wide = static_cast<float>(2 * std::atan(half) / degree);
        small_dim(fmt::format("{:.1f}° in a 16:9 picture of the same width", in_wide));
        p->fov_y_deg = in_wide;
    } else if (auto* o = std::get_if<Orthographic>(&drawn)) {
        o->height = static_cast<float>(o->height * share);
    }
    if (edited) written = drawn;
}

}  // namespace

void camera_panel(Camera& camera, PictureSize size) {
    FieldPanel panel(camera, "/camera");
    panel.draw({"eye", "target"});
    look_from(camera);
    section_heading("Projection");
    ProjectionKind kind = kind_of(camera.projection);
    if (choice_field("Kind", kind, {"How the view volume is projected", "/camera/projection/type"}))
        camera.projection = as_projection(camera, kind, size);
    projection_fields(camera.projection, size);
    if (fold("Advanced", camera.up != Camera{}.up, field_is_asked_below("/camera"))) panel.rest();
}

void shading_panel(Shading& shading, Transport& transport, glm::vec3& global_ambient) {
    static const Shading usual;
    FieldPanel panel(shading, "/shading");
    panel.draw({"mode", "reflection"});
    FieldPanel paths(transport, "/transport");
    paths.draw({"model"});
    const bool bounces = transport.model == TransportModel::Bounces;
    if (bounces || field_is_asked_below("/transport")) paths.rest();
    panel.group("terms", shading.terms, field_rows<Terms>);
    const Help help{"Ambient light from all directions, independent of the lights", "/global_ambient"};
    draw_asked(help.pointer, Typed::Number,
               [&] { colour_field("Global", global_ambient, Scene{}.global_ambient, help); });
    const bool asked = field_is_asked_below("/shading");
    const bool is_usual = shading.cull == usual.cull && !shading.two_sided && shading.local_viewer &&
                          shading.rules == usual.rules && shading.flat_point == usual.flat_point &&
                          shading.power_table == usual.power_table &&
                          shading.interpolation == usual.interpolation;
    if (fold("Advanced", !is_usual, asked)) panel.rest();
}

void display_panel(Display& display) {
    FieldPanel(display, "/display").draw({"exposure", "transfer"}).rest();
}

void npr_panel(Npr& npr) {
    FieldPanel panel(npr, "/npr");
    const bool asked = field_is_asked_below("/npr");
    if (fold("Cool to warm", npr.cool_to_warm, asked))
        panel.draw({"cool_to_warm", "cool", "warm", "alpha", "beta"});
    else
        panel.skip("cool_to_warm").skip("cool").skip("warm").skip("alpha").skip("beta");
    if (fold("Strokes", npr.silhouettes || npr.creases, asked)) panel.rest();
}

}  // namespace glint
