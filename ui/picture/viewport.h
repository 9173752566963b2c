#pragma once
// Handles presses, drags, clicks and the wheel on the picture.

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "ui/commands/keys.h"
#include "ui/picture/handles/hand.h"

namespace glint {

enum class Gesture { None, Press, Orbit, Pan, Dolly, Hand, Effect };

/// A light that follows the cursor by its effect.
struct HeldEffect {
    LightEffect effect = LightEffect::Brightest;
    int light = 0;  // in Scene::lights
    Light start;
    bool no_solution = false;  // no light can do that under the cursor: it waits as it is
};

struct ViewportState {
    Gesture gesture = Gesture::None;
    glm::dvec2 pressed_px{0}, last_px{0};
    double grip_depth = 1;                // of what the camera gesture holds on to
    Grip hovered_grip, pressed_grip;      // under the cursor now, and when the button went down
    Held held;                            // under Gesture::Hand
    HeldEffect effect;                    // under Gesture::Effect
    std::optional<MainLight> main_light;  // of several lights, the one that counts most under a free cursor
    GizmoMode gizmo = GizmoMode::Move;
    std::optional<glm::dvec3>
        pivot;     // what GizmoMode::Rotate turns about, world coordinates; else where the gizmo stands
    Scene before;  // as it was when the gesture began: Esc brings it back
    std::optional<glm::dvec2> probe;         // the pixel asked about, as a share of the picture's size
    std::optional<glm::dvec2> probe_before;  // the one that was asked about before, likewise
    PictureSize shares_of{0, 0};  // the picture in which they, and the scope's line, are these shares
    bool hovered = false;         // the cursor is over the picture
    bool asked = false;           // a pixel was clicked in this frame
    bool touched = false;         // someone has used the picture: the hints go
    double last_wheel = -1e9;     // time
    bool wheel_goes_on = false;   // this frame's notch belongs to the one before: one view
};

/// Ends the gesture and puts the scene back to where it began. True when there was one.
bool cancel_gesture(ViewportState& state, Scene& scene);

/// Asks about another pixel (a share of the picture's size), or about none.
void ask_about(ViewportState& state, std::optional<glm::dvec2> probe);
/// Asks again about the pixel before; a second time, about this one again.
void ask_as_before(ViewportState& state);

/// Finds the light that matters most at the pixel under a cursor that holds nothing: of several, on the
/// surfaces of the open scene.
void find_main_light(ViewportState& state, const ViewportFrame& frame, glm::dvec2 cursor_px);

/// Lets the selected light (if none is, the one that matters most under the cursor) follow the cursor by its
/// effect until a click keeps it or cancel_gesture() puts it back. Does nothing without a light.
void begin_effect(ViewportState& state, Scene& scene, Selection& selection, LightEffect effect);
void follow_effect(ViewportState& state, const ViewportFrame& frame, glm::dvec2 cursor_px);
[[nodiscard]] HandNote note_of(const HeldEffect& held, const Scene& scene);
[[nodiscard]] std::string hint_of(const HeldEffect& held);

/// Asks about the pixel so far to the right and down from the one asked about, at most as far as the picture's
/// border; where none is asked about, about the one in the middle.
void step_probe(ViewportState& state, PictureSize size, glm::ivec2 step);

/// The pixel asked about, in a picture of this size; none when it lies outside.
[[nodiscard]] std::optional<glm::ivec2> probe_pixel(const ViewportState& state, PictureSize size);

/// Draws handles, the probe, and the note at the hand.
void draw_overlay(ImDrawList& list, const ViewportState& state, const ViewportFrame& frame);

/// Says for the status line what a drag or click would do now.
[[nodiscard]] std::string gesture_hint(const ViewportState& state, const Scene& scene);

}  // namespace glint
