#include "ui/picture/viewport.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "ui/picture/draw_picture.h"
#include "ui/picture/orbit.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

constexpr double drag_threshold = 3;  // logical pixels before a press becomes a drag
constexpr double wheel_step = 0.88;   // of the distance, per notch
constexpr double scroll_units = 36;   // design units that a notch pans or turns by
constexpr double wheel_pause = 0.6;   // seconds: notches closer than this are one step

glm::dvec2 cursor_px(const ViewportFrame& frame) { return frame.view.to_pixel(ImGui::GetIO().MousePos); }

/// Depth of the surface under the cursor; over the background, of the target.
double depth_under(const ViewportFrame& frame, glm::dvec2 pixel) {
    const bool drawn = is_inside(frame.view.map.size, pixel) && frame.renderer != nullptr;
    const float depth = drawn ? frame.renderer->depth_at(int(pixel.x), int(pixel.y)) : 0;
    return depth > 0 ? double(depth) : target_depth(frame.scene.camera);
}

HandKeys hand_keys(const UiInput& input) {
    const ImGuiIO& io = ImGui::GetIO();
    return {io.KeyShift, io.KeyCtrl, io.KeyAlt, input.axis_held};
}

void begin(ViewportState& state, const ViewportFrame& frame, Gesture gesture) {
    state.gesture = gesture;
    state.before = frame.scene;
    state.pressed_px = state.last_px = cursor_px(frame);
    state.grip_depth = depth_under(frame, state.pressed_px);
}

/// Returns the pressed button.
int press(ViewportState& state, ViewportFrame& frame) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        begin(state, frame, Gesture::Press);
        state.pressed_grip = state.hovered_grip;
        state.pressed_mark = state.hovered_grip.is_mark();
        if (!state.pressed_mark) return ImGuiMouseButton_Left;
        if (state.hovered_grip.kind == GripKind::Light)
            frame.selection = {Selection::Kind::Light, state.hovered_grip.item};
        if (!state.hovered_grip.in_picture) state.gesture = Gesture::None;
        return ImGuiMouseButton_Left;
    }
    for (const int button : {ImGuiMouseButton_Middle, ImGuiMouseButton_Right}) {
        if (!ImGui::IsMouseClicked(button)) continue;
        begin(state, frame, ImGui::GetIO().KeyCtrl ? Gesture::Dolly : Gesture::Pan);
        return button;
    }
    return not_taken;
}

/// Turns a press that moved far enough into a drag.
void decide(ViewportState& state, const ViewportFrame& frame, const UiInput& input) {
    const double moved = glm::length(cursor_px(frame) - state.pressed_px) * frame.view.units_per_pixel;
    if (moved < double(px(float(drag_threshold)))) return;
    if (state.pressed_grip) {
        state.gesture = Gesture::Hand;
        state.held = take_hold(frame, state.pressed_grip, state.pressed_px, hand_keys(input));
        return;
    }
    const ImGuiIO& io = ImGui::GetIO();
    state.gesture = io.KeyShift ? Gesture::Pan : io.KeyCtrl ? Gesture::Dolly : Gesture::Orbit;
}

void move(ViewportState& state, ViewportFrame& frame, const UiInput& input) {
    if (state.gesture == Gesture::Press) decide(state, frame, input);
    const glm::dvec2 cursor = cursor_px(frame), motion = cursor - state.last_px;
    const PictureSize size = frame.view.map.size;
    Camera& camera = frame.scene.camera;
    switch (state.gesture) {
    case Gesture::None:
    case Gesture::Press:
    case Gesture::Effect:
        return;
    case Gesture::Hand:
        drag_held(state.held, frame, cursor, state.last_px, hand_keys(input));
        break;
    case Gesture::Orbit:
        orbit(camera, motion, size);
        break;
    case Gesture::Pan:
        pan(camera, state.last_px, cursor, state.grip_depth, size);
        break;
    case Gesture::Dolly:
        dolly(camera, state.pressed_px, depth_under(frame, state.pressed_px),
              std::exp(motion.y / size.height * 3), size);
        break;
    }
    if (state.gesture != Gesture::Hand) keep_depth_range(camera, state.before.camera, frame.view.bounds);
    state.touched = true;
    state.last_px = cursor;
}

void click(ViewportState& state, PictureSize size) {
    state.touched = true;
    if (state.pressed_grip.is_mark()) return;  // it was selected when pressed
    state.asked = true;
    // Uses the pixel's centre: near its edge, pictures of another shape might pick the neighbour.
    const glm::dvec2 middle = glm::dvec2(nearest_pixel(size, state.pressed_px)) + 0.5;
    ask_about(state, middle / glm::dvec2(size.width, size.height));
}

void end_gesture(ViewportState& state) {
    state.gesture = Gesture::None;
    state.pressed_grip = {};
    state.before = {};
}

void select_object_under(ViewportFrame& frame, glm::dvec2 pixel) {
    if (frame.renderer == nullptr) return;
    const glm::ivec2 at = nearest_pixel(frame.view.map.size, pixel);
    if (const int object = frame.renderer->object_at(at.x, at.y); object >= 0)
        frame.selection = {Selection::Kind::Object, object};
}

/// The wheel, or two fingers on a trackpad, moves the camera closer or away. With Shift, or sideways, the
/// picture follows the fingers; with Alt the camera turns.
void wheel(ViewportState& state, ViewportFrame& frame) {
    const ImGuiIO& io = ImGui::GetIO();
    state.wheel_goes_on = false;
    const glm::dvec2 scrolled{io.MouseWheelH, io.MouseWheel};
    if (!state.hovered || state.gesture != Gesture::None || scrolled == glm::dvec2(0)) return;
    const Camera before = frame.scene.camera;
    const glm::dvec2 cursor = cursor_px(frame);
    const double depth = depth_under(frame, cursor);
    const PictureSize size = frame.view.map.size;
    const glm::dvec2 way = scrolled * (scroll_units * double(px(1)) / double(frame.view.units_per_pixel));
    if (io.KeyAlt)
        orbit(frame.scene.camera, way, size);
    else if (io.KeyShift)
        pan(frame.scene.camera, cursor, cursor + way, depth, size);
    else {
        if (way.x != 0) pan(frame.scene.camera, cursor, cursor + glm::dvec2(way.x, 0), depth, size);
        if (way.y != 0) dolly(frame.scene.camera, cursor, depth, std::pow(wheel_step, scrolled.y), size);
    }
    keep_depth_range(frame.scene.camera, before, frame.view.bounds);
    state.wheel_goes_on = ImGui::GetTime() - state.last_wheel < wheel_pause;
    state.last_wheel = ImGui::GetTime();
    state.touched = true;
}

void set_cursor(const ViewportState& state) {
    if (state.gesture == Gesture::Orbit || state.gesture == Gesture::Pan || state.gesture == Gesture::Dolly)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    else if (state.gesture == Gesture::Hand || (state.hovered && state.hovered_grip))
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

ViewportFrame viewport_frame(UiState& state, const PictureView& view) {
    return {state.editor.scene(), state.editor.selection, renderer_of_open_scene(state, view.map.size), view,
            state.viewport.gizmo, state.viewport.pivot};
}

/// The renderer of the picture under the cursor, which may be a part of a comparison; null if its lights
/// differ from those of the edited scene.
const Renderer* renderer_under(const UiState& state, const ViewportFrame& frame) {
    if (state.on_screen.is_out_of_hand() || frame.renderer == nullptr) return nullptr;
    const ShownPart* part = part_at(state, nearest_pixel(frame.view.map.size, cursor_px(frame)));
    if (part == nullptr) return frame.renderer;
    return part->other == nullptr ? part->renderer : nullptr;
}

/// Whether highlights and terminators of the edited scene are visible under the cursor: not in cells of the
/// grid, in false colours, in a difference, or in a part that shows another model or scene.
bool shows_effects(const UiState& state, const ViewportFrame& frame) {
    const ShownPart* part = part_at(state, nearest_pixel(frame.view.map.size, cursor_px(frame)));
    return !state.on_screen.resting && part != nullptr && part->has_effects;
}

/// A light that follows the mouse takes precedence everywhere.
bool hover_with_effect(ViewportState& state, const ViewportFrame& frame) {
    state.hovered = ImGui::IsItemHovered();
    state.hovered_grip = {};
    state.wheel_goes_on = false;
    state.main_light.reset();
    if (state.hovered) follow_effect(state, frame, cursor_px(frame));
    if (state.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return true;
}

/// A click confirms the light's effect, the right button reverts it.
void end_effect(ViewportState& state, Scene& scene) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) (void)cancel_gesture(state, scene);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) end_gesture(state);
}

bool hand_hover(ToolFrame& tool) {
    ViewportState& state = tool.state.viewport;
    ViewportFrame frame = viewport_frame(tool.state, tool.view);
    state.asked = state.pressed_mark = false;
    if (state.gesture == Gesture::Effect) return hover_with_effect(state, frame);
    state.hovered = tool.over;
    // With Alt, only the camera can be grabbed; in a scene other than the edited one, nothing can be.
    const bool takes_hold = state.hovered && !ImGui::GetIO().KeyAlt && !tool.state.on_screen.is_out_of_hand();
    state.hovered_grip = takes_hold ? grip_under(frame, cursor_px(frame)) : Grip{};
    if (!state.hovered_grip.is_mark() && !shows_effects(tool.state, frame)) state.hovered_grip = {};
    ViewportFrame seen = frame;
    seen.renderer = renderer_under(tool.state, frame);
    find_main_light(state, seen, cursor_px(frame));
    if (!tool.state.on_screen.refusal().empty()) return tool.over;
    wheel(state, frame);
    set_cursor(state);
    return tool.over;
}

int hand_press(ToolFrame& tool) {
    ViewportState& state = tool.state.viewport;
    const std::optional<OtherScene>& other = tool.state.on_screen.resting;
    if (other && state.gesture == Gesture::None) {
        const bool takes_press = other->press != nullptr && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
        if (takes_press) other->press(tool.state);
        if (takes_press || !other->refusal.empty()) return not_taken;
    }
    ViewportFrame frame = viewport_frame(tool.state, tool.view);
    if (state.gesture == Gesture::Effect) {
        end_effect(state, frame.scene);
        return not_taken;
    }
    const int button = press(state, frame);
    if (!state.hovered_grip.is_mark() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        select_object_under(frame, cursor_px(frame));
    return state.gesture == Gesture::None ? not_taken : button;
}

bool hand_drag(ToolFrame& tool) {
    ViewportState& state = tool.state.viewport;
    ViewportFrame frame = viewport_frame(tool.state, tool.view);
    state.asked = state.pressed_mark = state.wheel_goes_on = false;
    state.hovered = ImGui::IsItemHovered();
    move(state, frame, tool.input);
    set_cursor(state);
    return state.gesture != Gesture::None;
}

void hand_release(ToolFrame& tool) {
    ViewportState& state = tool.state.viewport;
    if (state.gesture == Gesture::Press) click(state, tool.view.map.size);
    const double moved = glm::length(state.last_px - state.pressed_px) * tool.view.units_per_pixel;
    state.wants_menu = state.gesture == Gesture::Pan && ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
                       moved < double(px(float(drag_threshold)));
    end_gesture(state);
}

std::string hand_hint(const UiState& state) {
    const std::optional<OtherScene>& other = state.on_screen.resting;
    if (other && !other->hint.empty() && state.viewport.hovered) return other->hint;
    return gesture_hint(state.viewport, state.editor.scene());
}

}  // namespace

const Tool hand_tool{hand_hover, hand_press, hand_drag, hand_release, hand_hint};

void draw_hand(ImDrawList& list, UiState& state, const PictureView& view) {
    ViewportFrame frame = viewport_frame(state, view);
    if (!state.on_screen.is_out_of_hand()) return draw_overlay(list, state.viewport, frame);
    OtherScene other = *state.on_screen.resting;
    const bool is_drawn = state.rendered_scene == other.scene && state.rendered->size == view.map.size;
    draw_overlay(list, state.viewport,
                 {other.scene, other.selection, is_drawn ? state.renderer.get() : nullptr, view, frame.gizmo,
                  frame.pivot});
}

bool cancel_gesture(ViewportState& state, Scene& scene) {
    if (state.gesture == Gesture::None) return false;
    scene = state.before;
    end_gesture(state);
    return true;
}

}  // namespace glint
