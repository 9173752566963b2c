#pragma once
// Draws the picture when it must be drawn, as large as there is time for.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"
#include "ui/commands/keys.h"
#include "ui/picture/screen.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

/// A scene that is shown in place of the edited one, and what it is called in a sentence and over a part of a
/// comparison.
struct OtherScene {
    Scene scene;
    const char* name = "";
    std::string label = "";
};

// Keeps a drag fluent: if a full picture takes too long, smaller ones are drawn while something moves, and
// the full one as soon as it rests. A state machine of its own: milliseconds in, a divisor out.

/// A picture at full size that takes longer than this is drawn smaller while something moves.
inline constexpr double slow_picture_ms = 33;

struct FramePace {
    double slow_ms = slow_picture_ms;  // infinite where no hand waits
    int divisor = 1;                   // of the picture's width and height, for the next picture
    double full_ms = 0;                // what one of full size took, or is judged to take
    bool in_vain = false;              // smaller ones are not faster: the time goes elsewhere
    double rests_since = 0;            // seconds on the clock that the caller keeps: the last change
    int drawn_at = 0;  // divisor of the picture drawn in this frame; 0: none was, or nothing moves
};

/// Smaller ones are chosen to take about this.
inline constexpr double wanted_picture_ms = 24;
inline constexpr int largest_divisor = 4;
/// The hand rests when nothing has changed for so long, in seconds: then the full picture is drawn.
inline constexpr double rest_before_full = 0.15;

/// A gesture has ended: the next picture is a full one.
void end_of_motion(FramePace& pace);

/// Learns from a picture drawn at `divisor` in `ms`, while something moves.
void picture_took(FramePace& pace, int divisor, double ms);

/// `full` divided, each side at least 1.
[[nodiscard]] PictureSize divided(PictureSize full, int divisor);

/// Whether both scenes show the same surfaces in the same pixels of a picture, by the same numbers: camera,
/// objects, meshes and transforms are the same. Lights, materials and shading may differ.
[[nodiscard]] bool same_surfaces(const Scene& a, const Scene& b);

/// Returns the renderer, which tells what of the open scene shows at a pixel of a picture of this size. Null
/// if its last picture cannot tell: it has another size, or shows other surfaces because keys changed the
/// scene afterwards or because it is a preview of another scene. Hovering, picking and dragging use this
/// function, so that they never get the index of an object that does not exist.
[[nodiscard]] const Renderer* renderer_of_open_scene(const UiState& state, PictureSize size);

/// Freezes what is shown: the drawn scene and its selection, until `lecture.frozen` is reset.
void freeze(UiState& state);
/// What is said to a hand that would pick another pixel of a frozen picture.
[[nodiscard]] std::string it_is_frozen();

/// Returns the scene that the next picture shows in place of the edited one, with its meshes; nothing of it
/// reaches the history or a file. The first that wants one wins: what is frozen, what is animated, what the
/// mouse points at in the column, B.
[[nodiscard]] std::optional<Scene> preview_of(const UiState& state);

/// Where numbers of B are told.
inline constexpr const char* name_of_stored = "B, the stored scene";

/// Whether `explanation` is there and about the edited scene: its lights and objects are those that can be
/// selected and edited.
[[nodiscard]] bool is_explained(const UiState& state);

/// The scene that `explanation` is about.
[[nodiscard]] const Scene& asked_scene(const UiState& state);
/// The same scene to be edited; null where it is not the edited one.
[[nodiscard]] Scene* editable_scene(UiState& state);

/// The scene that rests on the screen in place of the edited one while no cells of Light × term are kept
/// there.
[[nodiscard]] std::optional<OtherScene> resting_below_cells(const UiState& state);

/// Whether the picture shows what the column asks it to show in place of the scene: nothing is frozen or
/// plays.
[[nodiscard]] bool column_has_turn(const UiState& state);

/// Whether the picture shows a scene that a hand in it does not edit: a frozen one, one that plays, or B.
[[nodiscard]] bool is_out_of_hand(const UiState& state);

/// The scene that the picture shows, previews of a moment aside: what is copied or exported of it.
[[nodiscard]] const Scene& shown_scene(const UiState& state);

/// Draws what shows (the edited scene or a preview) if it, or the size, is not that of the last picture; then
/// asks about the probe, unless what shows is a preview of a moment. While a hand moves something, a picture
/// that would take too long is a smaller one.
void draw_picture(UiState& state, const PictureView& view);

/// Learns how long the pictures of this frame took, those of a comparison's parts included. After
/// update_views().
void learn_pace(UiState& state);

// The room in the middle of the window: the picture, the hand on it, and what is drawn over it.

/// Keeps what lies over the picture on what it lies on when the picture gets another shape, and so another
/// field of view: the pixels asked about, the scope's line and card, what the pen drew. It may come to lie
/// outside; it waits there until the picture is wide enough again.
void follow_shape(UiState& state, PictureSize size);

/// Where the picture goes and how large it is in real pixels.
[[nodiscard]] PictureView picture_view(const Rect& centre, const UiState& state);

/// Places the picture and reads what a hand does on it. True while a gesture has the scene in hand.
[[nodiscard]] bool picture_room(UiState& state, const Layout& layout, const UiInput& input);

/// Draws handles, vectors, views, the pen, notifications. After the picture was drawn, so that they agree
/// with it.
void picture_overlay(UiState& state, const Layout& layout);

}  // namespace glint
