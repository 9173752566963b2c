// What is drawn over the picture, and what the status line says of it.
#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "models/saturate.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"
#include "ui/picture/viewport.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

/// An object stands before the handle. A little slack, so that a light on a surface does not flicker.
bool is_hidden(const Handle& handle, const ViewportFrame& frame) {
    if (!handle.in_picture || frame.renderer == nullptr) return false;
    const PictureSize size = frame.view.map.size;
    const int x = std::clamp(saturated_int(handle.at.pixel.x), 0, size.width - 1),
              y = std::clamp(saturated_int(handle.at.pixel.y), 0, size.height - 1);
    const double depth = frame.renderer->depth_at(x, y);
    return depth > 0 && handle.at.depth > depth * 1.01;
}

/// A highlight or a terminator under the hand: a ring there, and a line to the light that makes it.
void draw_hold_on_surface(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const bool held = state.gesture == Gesture::Hand;
    const Grip& grip = held ? state.held.grip : state.hovered_grip;
    if (!exists(grip, frame.scene) || grip.is_mark() || (!held && !state.hovered)) return;
    const Light& light = frame.scene.lights[static_cast<std::size_t>(grip.item)];
    const ImVec2 hand = ImGui::GetIO().MousePos;
    const ImU32 colour = to_u32(colour_of(light)), dark = to_u32({0, 0, 0, 1}, 0.5f);
    const OnScreen to = project(frame.view.map, handle_of(light, frame.view.dome, frame.view.map));
    if (to.in_front) {
        const ImVec2 end = frame.view.to_window(to.pixel);
        list.AddLine(hand, end, dark, px(2.6f));
        list.AddLine(hand, end, colour, px(1.2f));
    }
    const float radius = px(held ? 7 : 10);
    list.AddCircle(hand, radius, dark, 0, px(4));
    list.AddCircle(hand, radius, held && state.held.no_solution ? to_u32(theme().dim_text) : colour, 0,
                   px(2));
}

void draw_gizmo_of_selected(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    if (frame.selection.kind != Selection::Kind::Object) return;
    const auto index = static_cast<std::size_t>(frame.selection.index);
    if (index >= frame.scene.objects.size()) return;
    const bool held = state.gesture == Gesture::Hand;
    const Grip& grip = held ? state.held.grip : state.hovered_grip;
    std::optional<GizmoPart> in_hand;
    if (grip.kind == GripKind::Object) in_hand = grip.part;
    const auto gizmo = gizmo_of(frame.scene.objects[index].transform, state.gizmo, frame.view, state.pivot);
    if (gizmo) draw_object_gizmo(list, frame.view, *gizmo, state.gizmo, in_hand);
}

void draw_probe(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const auto pixel = probe_pixel(state, frame.view.map.size);
    if (!pixel) return;
    const ImVec2 at = frame.view.to_window(glm::dvec2(*pixel) + 0.5);
    const float in = px(5), out = px(12);
    const auto cross = [&](ImU32 colour, float width) {
        list.AddLine({at.x - out, at.y}, {at.x - in, at.y}, colour, width);
        list.AddLine({at.x + in, at.y}, {at.x + out, at.y}, colour, width);
        list.AddLine({at.x, at.y - out}, {at.x, at.y - in}, colour, width);
        list.AddLine({at.x, at.y + in}, {at.x, at.y + out}, colour, width);
        list.AddCircle(at, in, colour, 0, width);
    };
    cross(to_u32({0, 0, 0, 1}, 0.6f), px(3.2f));
    cross(to_u32({1, 1, 1, 1}), px(1.4f));
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
