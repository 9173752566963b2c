// Draws handles, the probe and notes over the picture, and returns the status line's hint about a drag.
#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"
#include "ui/picture/viewport.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Whether an object is in front of the handle. A small tolerance keeps a light on a surface from flickering.
bool is_hidden(const Handle& handle, const ViewportFrame& frame) {
    if (!handle.in_picture || frame.renderer == nullptr) return false;
    const glm::ivec2 at = nearest_pixel(frame.view.map.size, handle.at.pixel);
    const double depth = frame.renderer->depth_at(at.x, at.y);
    return depth > 0 && handle.at.depth > depth * 1.01;
}

/// Marks a highlight or a terminator that is hovered or dragged: a ring there, and a line to its light.
void draw_hold_on_surface(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const bool effect = state.gesture == Gesture::Effect, held = state.gesture == Gesture::Hand || effect;
    const Grip follows{.kind = GripKind::Highlight, .item = state.effect.light};
    const Grip& grip = effect ? follows : held ? state.held.grip : state.hovered_grip;
    if (!exists(grip, frame.scene) || grip.is_mark() || (!held && !state.hovered)) return;
    const Light& light = frame.scene.lights[static_cast<std::size_t>(grip.item)];
    const ImVec2 hand = ImGui::GetIO().MousePos;
    const ImU32 colour = to_u32(colour_of(light));
    const ProjectedPoint to = project(frame.view.map, handle_of(light, frame.view.dome, frame.view.map));
    if (to.in_front) cased_line(list, hand, frame.view.to_window(to.pixel), colour);
    const bool waits = held && (effect ? state.effect.no_solution : state.held.no_solution);
    cased_circle(list, hand, held ? 7 : 10, waits ? to_u32(theme().dim_text) : colour, 2);
}

void draw_gizmo_of_selected(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const bool held = state.gesture == Gesture::Hand;
    const auto gizmo = selected_gizmo(frame, held ? &state.held : nullptr);
    if (!gizmo) return;
    const Grip& grip = held ? state.held.grip : state.hovered_grip;
    std::optional<GizmoPart> in_hand;
    if (grip.kind == GripKind::Object) in_hand = grip.part;
    draw_object_gizmo(list, frame.view, *gizmo, state.gizmo, in_hand);
}

void draw_probe(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const auto pixel = probe_pixel(state, frame.view.map.size);
    if (!pixel) return;
    const ImVec2 at = frame.view.to_window(glm::dvec2(*pixel) + 0.5);
    const ImU32 white = to_u32({1, 1, 1, 1});
    for (const ImVec2 way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
        cased_line(list, at + px(5) * way, at + px(12) * way, white, 1.4f);
    cased_circle(list, at, 5, white, 1.4f);
}

/// The area in the window of the object under the cursor, where the light's effect is visible.
std::optional<Rect> object_under(const ViewportFrame& frame) {
    const glm::dvec2 cursor = frame.view.to_pixel(ImGui::GetIO().MousePos);
    if (frame.renderer == nullptr || !is_inside(frame.view.map.size, cursor)) return {};
    const int object = frame.renderer->object_at(int(cursor.x), int(cursor.y));
    if (object < 0 || !frame.scene.objects[static_cast<std::size_t>(object)].mesh) return {};
    const Object& shown = frame.scene.objects[static_cast<std::size_t>(object)];
    const glm::dmat4 world = world_from_object(shown.transform);
    std::optional<Rect> covered;
    for (const glm::dvec3& corner : corners_of(shown.mesh->bounds)) {
        const ProjectedPoint at = project(frame.view.map, glm::dvec3(world * glm::dvec4(corner, 1)));
        if (!at.in_front) return {};
        const ImVec2 p = frame.view.to_window(at.pixel);
        if (!covered) covered = Rect{p, p};
        covered->low = {std::min(covered->low.x, p.x), std::min(covered->low.y, p.y)};
        covered->high = {std::max(covered->high.x, p.x), std::max(covered->high.y, p.y)};
    }
    return covered;
}

void draw_hand_note(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const bool resting =
        state.hovered && state.gesture == Gesture::None && exists(state.hovered_grip, frame.scene);
    const bool effect = state.gesture == Gesture::Effect && state.hovered;
    if (state.gesture != Gesture::Hand && !resting && !effect) return;
    const HandNote note = effect    ? note_of(state.effect, frame.scene)
                          : resting ? note_of(state.hovered_grip, frame.scene)
                                    : note_of(state.held, frame.scene);
    const bool is_mark = !effect && (resting ? state.hovered_grip : state.held.grip).is_mark();
    draw_note(list, ImGui::GetIO().MousePos, note, is_mark ? std::nullopt : object_under(frame));
}

/// Draws the line from a light to the point that it is being aimed at.
void draw_aim(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    if (state.gesture != Gesture::Hand || !exists(state.held.grip, frame.scene)) return;
    const auto* drag = std::get_if<ShapeDrag>(&state.held.drag);
    if (drag == nullptr || !drag->aimed) return;
    const Light& light = frame.scene.lights[static_cast<std::size_t>(state.held.grip.item)];
    const WorldPen pen{list, frame.view};
    const ImU32 colour = to_u32(colour_of(light));
    pen.cased(handle_of(light, frame.view.dome, frame.view.map), *drag->aimed, colour, 0.6f);
    pen.mark(*drag->aimed, colour, 1, true);
}

}  // namespace

void draw_overlay(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const std::vector<Handle> handles =
        light_handles(frame.scene, frame.view, selected_light(frame.selection));
    const bool few = handles.size() <= 24;
    draw_hold_on_surface(list, state, frame);
    const Grip& grip = state.gesture == Gesture::Hand ? state.held.grip : state.hovered_grip;
    for (const Handle& handle : handles) {
        const Light& light = frame.scene.lights[static_cast<std::size_t>(handle.light)];
        const bool hand_on_it = grip && grip.kind != GripKind::Object && grip.item == handle.light;
        HandleLook look{.selected = frame.selection == Selection{Selection::Kind::Light, handle.light},
                        .hovered = hand_on_it,
                        .hidden = is_hidden(handle, frame),
                        .stem = few,
                        .matters = state.main_light && state.main_light->light == handle.light,
                        .shape_in_hand = {}};
        if (hand_on_it && grip.kind == GripKind::Shape)
            look.shape_in_hand = place_of(grip.shape, light, frame.view.dome, frame.view.map);
        draw_handle(list, frame.view, light, handle, look);
    }
    draw_aim(list, state, frame);
    draw_gizmo_of_selected(list, state, frame);
    draw_probe(list, state, frame);
    draw_hand_note(list, state, frame);
}

std::string gesture_hint(const ViewportState& state, const Scene& scene) {
    switch (state.gesture) {
    case Gesture::Hand:
        return hint_of(state.held);
    case Gesture::Effect:
        return hint_of(state.effect);
    case Gesture::Orbit:
        return "Orbiting round the target · Esc: cancel";
    case Gesture::Pan:
        return "Panning · Esc: cancel";
    case Gesture::Dolly:
        return "Moving closer and away · Esc: cancel";
    case Gesture::None:
    case Gesture::Press:
        break;
    }
    if (!state.hovered) return {};
    const bool is_on_grip = exists(state.hovered_grip, scene);
    const std::string does =
        is_on_grip ? hint_of(state.hovered_grip, scene)
                   : "Click: why this colour · Drag: orbit · Shift+drag or right: pan · Wheel: closer";
    if ((is_on_grip && state.hovered_grip.is_mark()) || !state.main_light ||
        static_cast<std::size_t>(state.main_light->light) >= scene.lights.size())
        return is_on_grip ? does : does + " · F: frame";
    return fmt::format("{}: {:.0f} % of R + G + B here ({} selects it) · {}",
                       whole_label(scene.lights[static_cast<std::size_t>(state.main_light->light)].name),
                       100 * state.main_light->share, keys_of(CommandId::SelectMainLight), does);
}

}  // namespace glint
