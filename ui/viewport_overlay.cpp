// What is drawn over the picture, and what the status line says of it.
#include <fmt/core.h>

#include <glm/geometric.hpp>

#include "ui/fonts.h"
#include "ui/theme.h"
#include "ui/viewport.h"

namespace glint {
namespace {

/// An object stands before the handle. A little slack, so that a light on a surface does not flicker.
bool is_hidden(const Handle& handle, const ViewportFrame& frame) {
    if (!handle.in_picture || frame.renderer == nullptr) return false;
    const PictureSize size = frame.view.map.size;
    const int x = std::min(int(handle.at.pixel.x), size.width - 1),
              y = std::min(int(handle.at.pixel.y), size.height - 1);
    const double depth = frame.renderer->depth_at(x, y);
    return depth > 0 && handle.at.depth > depth * 1.01;
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
    cross(packed({0, 0, 0, 1}, 0.6f), px(3.2f));
    cross(packed({1, 1, 1, 1}), px(1.4f));
}

const char* along_words(DragAlong along, bool turns) {
    switch (along) {
    case DragAlong::ViewPlane:
        return turns ? "on its dome" : "in the view plane";
    case DragAlong::Depth:
        return turns ? "past the rim" : "in depth";
    case DragAlong::X:
        return turns ? "round X" : "along X";
    case DragAlong::Y:
        return turns ? "round Y" : "along Y";
    case DragAlong::Z:
        return turns ? "round Z" : "along Z";
    }
    return "";  // not reached
}

void draw_readout(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    if (state.gesture != Gesture::Light) return;
    const Light& light = frame.scene.lights[static_cast<std::size_t>(state.dragged_light)];
    const glm::vec4 p = light.position;
    const bool turns = light.kind == LightKind::Directional;
    draw_note(list, frame.view, ImGui::GetIO().MousePos,
              fmt::format("{} {}, {} coordinates", light.name, along_words(state.drag.along, turns),
                          light.space == LightSpace::World ? "world" : "camera"),
              fmt::format("{:7.2f} {:7.2f} {:7.2f}", p.x, p.y, p.z));
}

}  // namespace

void draw_overlay(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame) {
    const std::vector<Handle> handles =
        light_handles(frame.scene, frame.view, selected_light(frame.selection));
    const bool few = handles.size() <= 24;
    for (const Handle& handle : handles) {
        const bool dragged = handle.light == state.dragged_light && state.gesture == Gesture::Light;
        const HandleLook look{frame.selection == Selection{Selection::Kind::Light, handle.light},
                              dragged || handle.light == state.hovered_light, is_hidden(handle, frame), few};
        draw_handle(list, frame.view, frame.scene.lights[static_cast<std::size_t>(handle.light)], handle,
                    look);
    }
    draw_probe(list, state, frame);
    draw_readout(list, state, frame);
    const bool resting = state.hovered && state.gesture == Gesture::None;
    if (resting && state.hovered_light >= 0 &&
        static_cast<std::size_t>(state.hovered_light) < frame.scene.lights.size()) {
        const auto index = static_cast<std::size_t>(state.hovered_light);
        const Light& light = frame.scene.lights[index];
        const char* what = !state.hovered_in_picture ? "Outside the picture"
                           : light.enabled           ? "Drag to move"
                                                     : "Off; drag to move";
        draw_note(list, frame.view, ImGui::GetIO().MousePos, what, light.name);
    }
}

std::string gesture_hint(const ViewportState& state, const Scene& scene) {
    switch (state.gesture) {
    case Gesture::Light:
        return "Shift: in depth · X Y Z: along an axis · Ctrl: snap · Esc: cancel";
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
    if (state.hovered_light >= 0 && static_cast<std::size_t>(state.hovered_light) < scene.lights.size())
        return fmt::format("{}: drag in the view plane · Shift: in depth · X Y Z: axis · Ctrl: snap",
                           scene.lights[static_cast<std::size_t>(state.hovered_light)].name);
    return "Click: why this colour · Drag: orbit · Shift+drag or right: pan · Wheel: closer · F: frame";
}

}  // namespace glint
