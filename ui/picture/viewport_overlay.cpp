// Draws handles, the probe and notes over the picture, and tells the status line what a drag would do.
#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"
#include "ui/picture/viewport.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/parts.h"

namespace glint {
namespace {

/// Whether an object stands before the handle. A little slack, so that a light on a surface does not flicker.
bool is_hidden(const Handle& handle, const ViewportFrame& frame) {
    if (!handle.in_picture || frame.renderer == nullptr) return false;
    const glm::ivec2 at = nearest_pixel(frame.view.map.size, handle.at.pixel);
    const double depth = frame.renderer->depth_at(at.x, at.y);
    return depth > 0 && handle.at.depth > depth * 1.01;
}

/// A highlight or a terminator under the hand: a ring there, and a line to the light that makes it.
void draw_hold_on_surface(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const bool held = state.gesture == Gesture::Hand;
    const Grip& grip = held ? state.held.grip : state.hovered_grip;
    if (!exists(grip, frame.scene) || grip.is_mark() || (!held && !state.hovered)) return;
    const Light& light = frame.scene.lights[static_cast<std::size_t>(grip.item)];
    const ImVec2 hand = ImGui::GetIO().MousePos;
    const ImU32 colour = to_u32(colour_of(light));
    const OnScreen to = project(frame.view.map, handle_of(light, frame.view.dome, frame.view.map));
    if (to.in_front) cased_line(list, hand, frame.view.to_window(to.pixel), colour);
    const bool waits = held && state.held.no_solution;
    cased_circle(list, hand, held ? 7 : 10, waits ? to_u32(theme().dim_text) : colour, 2);
}

void draw_gizmo_of_selected(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const auto gizmo = selected_gizmo(frame);
    if (!gizmo) return;
    const bool held = state.gesture == Gesture::Hand;
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

void draw_hand_note(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const bool resting =
        state.hovered && state.gesture == Gesture::None && exists(state.hovered_grip, frame.scene);
    if (state.gesture != Gesture::Hand && !resting) return;
    const HandNote note =
        resting ? note_of(state.hovered_grip, frame.scene) : note_of(state.held, frame.scene);
    draw_note(list, frame.view, ImGui::GetIO().MousePos, note.title, note.numbers);
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
        HandleLook look{frame.selection == Selection{Selection::Kind::Light, handle.light},
                        hand_on_it,
                        is_hidden(handle, frame),
                        few,
                        {}};
        if (hand_on_it && grip.kind == GripKind::Shape)
            look.shape_in_hand = place_of(grip.shape, light, frame.view.dome, frame.view.map);
        draw_handle(list, frame.view, light, handle, look);
    }
    draw_gizmo_of_selected(list, state, frame);
    draw_probe(list, state, frame);
    draw_hand_note(list, state, frame);
}

std::string gesture_hint(const ViewportState& state, const Scene& scene) {
    switch (state.gesture) {
    case Gesture::Hand:
        return hint_of(state.held);
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
    if (exists(state.hovered_grip, scene)) return hint_of(state.hovered_grip, scene);
    return "Click: why this colour · Drag: orbit · Shift+drag or right: pan · Wheel: closer · F: frame";
}

}  // namespace glint
