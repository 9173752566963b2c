#pragma once
// Handles presses, drags, clicks and the wheel on the picture.

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "ui/commands/keys.h"
#include "ui/picture/handles/hand.h"

namespace glint {

enum class Gesture { None, Press, Orbit, Pan, Dolly, Hand, Effect };

/// A light that is moved so that its effect follows the cursor.
struct HeldEffect {
    LightEffect effect = LightEffect::Brightest;
    int light = 0;  // index into Scene::lights
    Light start;
    bool no_solution = false;  // no position of the light has the effect under the cursor: it does not move
};

struct ViewportState {
    Gesture gesture = Gesture::None;
    glm::dvec2 pressed_px{0}, last_px{0};
    double grip_depth = 1;            // depth of the point that the camera gesture keeps under the cursor
    Grip hovered_grip, pressed_grip;  // under the cursor now, and at the time of the press
    Held held;                        // under Gesture::Hand
    HeldEffect effect;                // under Gesture::Effect
    std::optional<MainLight>
        main_light;  // the light that contributes most under the cursor, if there are several
    GizmoMode gizmo = GizmoMode::Move;
    std::optional<glm::dvec3>
        pivot;     // the pivot of GizmoMode::Rotate, world coordinates; default: the gizmo's position
    Scene before;  // the scene when the gesture began; Esc restores it
    std::optional<glm::dvec2> probe;         // the picked pixel, as a fraction of the picture's size
    std::optional<glm::dvec2> probe_before;  // the previously picked pixel, in the same form
    PictureSize shares_of{0, 0};  // the picture size to which these fractions, and the scope's line, refer
    bool hovered = false;         // the cursor is over the picture
    bool asked = false;           // a pixel was clicked in this frame
    bool wants_menu = false;      // the right button was clicked in this frame
    bool pressed_mark = false;    // whether a light's handle or a gizmo was pressed in this frame
    bool touched = false;         // the picture has been used, so the hints disappear
    double last_wheel = -1e9;     // ImGui time
    bool wheel_goes_on = false;   // this frame's notch continues the previous one, as the same view change
};

/// Ends the gesture and restores the scene from before it. True if there was a gesture.
bool cancel_gesture(ViewportState& state, Scene& scene);

/// Picks a different pixel (as a fraction of the picture's size), or none.
void ask_about(ViewportState& state, std::optional<glm::dvec2> probe);
/// Picks the previously picked pixel; a second call picks the current one again.
void ask_as_before(ViewportState& state);

/// Finds the light that contributes most under an idle cursor, if there are several, on surfaces of the open
/// scene.
void find_main_light(ViewportState& state, const ViewportFrame& frame, glm::dvec2 cursor_px);

/// Moves the selected light (default: the one that contributes most under the cursor) so that its effect
/// follows the cursor, until a click confirms it or cancel_gesture() reverts it. Does nothing if there is no
/// light.
void begin_effect(ViewportState& state, Scene& scene, Selection& selection, LightEffect effect);
void follow_effect(ViewportState& state, const ViewportFrame& frame, glm::dvec2 cursor_px);
[[nodiscard]] HandNote note_of(const HeldEffect& held, const Scene& scene);
[[nodiscard]] std::string hint_of(const HeldEffect& held);

/// Moves the picked pixel by `step`, right and down, clamped to the picture; without a picked pixel, picks
/// the centre.
void step_probe(ViewportState& state, PictureSize size, glm::ivec2 step);

/// Returns the picked pixel in a picture of this size; nullopt if it is outside.
[[nodiscard]] std::optional<glm::ivec2> probe_pixel(const ViewportState& state, PictureSize size);

/// Draws handles, the probe, and the note at the cursor.
void draw_overlay(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame);

/// Returns what a drag or click would do now, for the status line.
[[nodiscard]] std::string gesture_hint(const ViewportState& state, const Scene& scene);

}  // namespace glint
