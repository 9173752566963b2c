#include "ui/hands/hand.h"

#include <cmath>

#include "ui/theme.h"

namespace glint {
namespace {

constexpr double terminator_reach = 4;  // units of the design

/// The surface, if the last picture shows it.
SurfaceView surface_of(const ViewportFrame& frame) {
    return {frame.scene, *frame.renderer, frame.view.map, frame.view.dome};
}

Light& light_of(const ViewportFrame& frame, const Grip& grip) {
    return frame.scene.lights[static_cast<std::size_t>(grip.item)];
}

DragAlong drag_along(const HandKeys& keys) {
    if (keys.axis[0]) return DragAlong::X;
    if (keys.axis[1]) return DragAlong::Y;
    if (keys.axis[2]) return DragAlong::Z;
    return keys.shift ? DragAlong::Depth : DragAlong::ViewPlane;
}

bool has_terminator_under(const ViewportFrame& frame, int light, glm::dvec2 cursor_px) {
    if (light < 0 || !frame.scene.shading.terms.diffuse) return false;
    const Light& selected = frame.scene.lights[static_cast<std::size_t>(light)];
    const double reach = terminator_reach * double(px(1)) / double(frame.view.units_per_pixel);
    return selected.enabled && terminator_under(surface_of(frame), selected, cursor_px, reach);
}

void drag_light(LightDrag& drag, const Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px,
                glm::dvec2 last_px, const HandKeys& keys) {
    Light& light = light_of(frame, held.grip);
    // Another key: go on from here, so that nothing jumps.
    if (const DragAlong along = drag_along(keys); along != drag.along) drag = {light, along, last_px};
    light = dragged(drag, held.view, cursor_px, keys.ctrl);
}

}  // namespace

Grip grip_under(const ViewportFrame& frame, glm::dvec2 cursor_px) {
    const int selected = selected_light(frame.selection);
    const std::vector<Handle> handles = light_handles(frame.scene, frame.view, selected);
    if (const Handle* handle = handle_under(handles, cursor_px, frame.view))
        return {GripKind::Light, handle->light, handle->in_picture};
    if (frame.renderer == nullptr) return {};
    if (has_terminator_under(frame, selected, cursor_px)) return {GripKind::Terminator, selected, true};
    if (const auto highlight = highlight_under(surface_of(frame), cursor_px))
        return {GripKind::Highlight, highlight->light, true};
    return {};
}

Held take_hold(const ViewportFrame& frame, Grip grip, glm::dvec2 cursor_px, const HandKeys& keys) {
    Held held{grip, {frame.view.map, frame.view.dome, snap_step_for(frame.view.bounds)}, {}, false};
    switch (grip.kind) {
    case GripKind::None:
        break;
    case GripKind::Light:
        held.drag = LightDrag{light_of(frame, grip), drag_along(keys), cursor_px};
        break;
    case GripKind::Highlight:
        if (frame.renderer == nullptr) break;
        if (const auto drag = grab_highlight(surface_of(frame), light_of(frame, grip), cursor_px))
            held.drag = *drag;
        break;
    case GripKind::Terminator:
        held.drag = TerminatorDrag{light_of(frame, grip)};
        break;
    }
    return held;
}

void drag_held(Held& held, ViewportFrame& frame, glm::dvec2 cursor_px, glm::dvec2 last_px,
               const HandKeys& keys) {
    if (auto* drag = std::get_if<LightDrag>(&held.drag))
        return drag_light(*drag, held, frame, cursor_px, last_px, keys);
    if (frame.renderer == nullptr) return;
    std::optional<Light> light;
    if (const auto* drag = std::get_if<HighlightDrag>(&held.drag))
        light = dragged_highlight(*drag, surface_of(frame), cursor_px);
    else if (const auto* line = std::get_if<TerminatorDrag>(&held.drag))
        light = dragged_terminator(*line, surface_of(frame), cursor_px);
    held.astray = !light;
    if (light) light_of(frame, held.grip) = *light;
}

}  // namespace glint
