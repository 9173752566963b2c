#include "ui/picture/viewport.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <utility>

#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"
#include "ui/picture/orbit.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double drag_threshold = 3;  // logical pixels after which a press becomes a drag
constexpr double wheel_step = 0.88;   // factor that multiplies the distance, per notch
constexpr double scroll_units = 36;   // design units per notch, for panning and turning
constexpr double wheel_pause = 0.6;   // seconds: notches closer together count as one step

glm::dvec2 cursor_px(const ViewportFrame& frame) { return frame.view.to_pixel(ImGui::GetIO().MousePos); }

/// Returns the depth of the surface under the cursor; over the background, the depth of the target.
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

/// Turns a press that has moved far enough into a drag.
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
    if (state.pressed_grip.is_mark()) return;  // the mark was selected when pressed
    state.asked = true;
    // Uses the pixel's centre: near the edge of a pixel, a picture of a different shape might pick the
    // neighbouring pixel.
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

/// Returns the renderer of the picture under the cursor, which may be a part of a comparison; null if its
/// lights differ from those of the edited scene.
const Renderer* renderer_under(const UiState& state, const ViewportFrame& frame) {
    if (state.on_screen.is_out_of_hand() || frame.renderer == nullptr) return nullptr;
    const ShownPart* part = part_at(state, nearest_pixel(frame.view.map.size, cursor_px(frame)));
    if (part == nullptr) return frame.renderer;
    return part->other == nullptr ? part->renderer : nullptr;
}

/// Whether highlights and terminators of the edited scene are visible under the cursor: not in cells of the
/// grid, in false colours, in a difference, or in a part that shows a different model or scene.
bool shows_effects(const UiState& state, const ViewportFrame& frame) {
    const ShownPart* part = part_at(state, nearest_pixel(frame.view.map.size, cursor_px(frame)));
    return !state.on_screen.resting && part != nullptr && part->has_effects;
}

/// Handles a light that follows the mouse, which takes precedence everywhere.
bool hover_with_effect(ViewportState& state, const ViewportFrame& frame) {
    state.hovered = ImGui::IsItemHovered();
    state.hovered_grip = {};
    state.wheel_goes_on = false;
    state.main_light.reset();
    if (state.hovered) follow_effect(state, frame, cursor_px(frame));
    if (state.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return true;
}

/// A click confirms the light's effect; the right button reverts it.
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

// Draws handles, the probe and notes over the picture, and returns the status line's hint about a drag.

namespace {

/// Whether an object is in front of the handle. A small tolerance keeps a light on a surface from flickering.
bool is_hidden(const Handle& handle, const ViewportFrame& frame) {
    if (!handle.in_picture || frame.renderer == nullptr) return false;
    const glm::ivec2 at = nearest_pixel(frame.view.map.size, handle.at.pixel);
    const double depth = frame.renderer->depth_at(at.x, at.y);
    return depth > 0 && handle.at.depth > depth * 1.01;
}

/// Marks a highlight or a terminator that is hovered or dragged: draws a ring there, and a line to its light.
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

/// Returns the area in the window of the object under the cursor, where the light's effect is visible.
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

// The context menu of the picture.

namespace {

struct PictureMenuState {
    glm::dvec2 pixel{0};  // the clicked pixel, in the drawn picture
};

/// Returns the light that the menu moves: the selected one, or else the one that contributes most at the
/// clicked pixel; -1: none.
int light_of(const UiState& state) {
    const int selected = selected_light(state.editor.selection);
    if (selected >= 0 || state.editor.scene().lights.empty()) return selected;
    return state.viewport.main_light ? state.viewport.main_light->light : 0;
}

bool item(const char* name, bool possible = true) {
    const bool chosen = ImGui::MenuItem(name, "", false, possible);
    list_control(name, "", last_item());
    return chosen;
}

void light_items(UiState& state, const PictureView& view, glm::dvec2 pixel) {
    const int index = light_of(state);
    const Renderer* const renderer = renderer_of_open_scene(state, view.map.size);
    Scene& scene = state.editor.scene();
    const bool possible = index >= 0 && renderer != nullptr && !state.on_screen.is_out_of_hand();
    if (!possible) return;
    Light& light = scene.lights[static_cast<std::size_t>(index)];
    const SurfaceView surface{scene, *renderer, view.map, view.dome};
    ImGui::Separator();
    const std::string name = whole_label(light.name);
    for (const auto& [label, effect] : {std::pair("Brightest here", LightEffect::Brightest),
                                        std::pair("Rim light here", LightEffect::Rim)}) {
        const std::optional<Light> moved = with_effect(effect, light, surface, pixel);
        if (item(fmt::format("{}: {}", label, name).c_str(), moved.has_value())) light = *moved;
    }
    const auto point = seen_at(*renderer, view.map.size, pixel);
    const bool has_aim = light.kind == LightKind::Spot || light.kind == LightKind::Area;
    if (item(fmt::format("Aim here: {}", name).c_str(), has_aim && point.has_value()))
        light = aimed_at(light, in_world(view.map, point->position, 1), {view.map, view.dome});
}

void copy_colour(UiState& state, glm::ivec2 at) {
    const Picture& shown = *state.displayed;
    const glm::ivec2 pixel = pixel_at_place(at, state.full_size, shown.size);
    const std::uint8_t* const bytes = &shown.rgba[4 * shown.pixel(pixel.x, pixel.y)];
    const std::string text = fmt::format("#{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2]);
    ImGui::SetClipboardText(text.c_str());
    state.notifications.tell(text + " is on the clipboard");
}

void draw_menu(ImDrawList&, UiState& state, const PictureView& view) {
    PictureMenuState& menu = state.get<PictureMenuState>();
    if (std::exchange(state.viewport.wants_menu, false) && state.on_screen.refusal().empty()) {
        menu.pixel = state.viewport.pressed_px;
        ImGui::OpenPopup("##picture menu");
    }
    if (!ImGui::BeginPopup("##picture menu")) return;
    const glm::ivec2 at = nearest_pixel(view.map.size, menu.pixel);
    if (item("Why this colour?")) {
        ask_about(state.viewport,
                  (glm::dvec2(at) + 0.5) / glm::dvec2(view.map.size.width, view.map.size.height));
        state.left_shows_inspector = state.layout.right = true;
    }
    if (item("Copy colour")) copy_colour(state, at);
    light_items(state, view, menu.pixel);
    ImGui::EndPopup();
}

}  // namespace

extern const Feature picture_menu_feature;
const Feature picture_menu_feature{.overlay = draw_menu};

}  // namespace glint
