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

/// Pixels of a picture, from `low` to before `high`.
struct PartRect {
    glm::ivec2 low{0}, high{0};
    [[nodiscard]] bool holds(glm::ivec2 p) const {
        return p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y;
    }
};

/// A part of the displayed picture, and how it is related to the edited scene.
struct ShownPart {
    PartRect rect;
    const Renderer* renderer = nullptr;  // that drew it; null: another program did
    const Scene* other = nullptr;  // the scene that it shows, if its objects are not those of the drawn one
    bool has_effects = true;       // highlights and terminators are where the edited scene has them
};

/// The part in which a pixel of the displayed picture lies; null: none.
[[nodiscard]] const ShownPart* part_at(const UiState& state, glm::ivec2 pixel);

/// Whether both scenes show the same surfaces in the same pixels of a picture, by the same numbers: camera,
/// objects, meshes and transforms are the same. Lights, materials and shading may differ.
[[nodiscard]] bool same_surfaces(const Scene& a, const Scene& b);

/// Returns the renderer, which tells what of the open scene shows at a pixel of a picture of this size. Null
/// if its last picture cannot tell: it has another size, or shows other surfaces because keys changed the
/// scene afterwards or because it is a preview of another scene. Hovering, picking and dragging use this
/// function, so that they never get the index of an object that does not exist.
[[nodiscard]] const Renderer* renderer_of_open_scene(const UiState& state, PictureSize size);

/// Draws what shows (the edited scene or a preview) if it, or the size, is not that of the last picture; then
/// asks about the probe, unless what shows is a preview of a moment. While a hand moves something, a picture
/// that would take too long is a smaller one.
void draw_picture(UiState& state, const PictureView& view);

/// Learns how long the pictures of this frame took, those of a comparison's parts included.
void learn_pace(UiState& state);

// The room in the middle of the window: the picture, the hand on it, and what is drawn over it.

/// Keeps what lies over the picture on what it lies on when the picture gets another shape, and so another
/// field of view. It may come to lie outside; it waits there until the picture is wide enough again.
void follow_shape(UiState& state, PictureSize size);

/// Where the picture goes and how large it is in real pixels.
[[nodiscard]] PictureView picture_view(const Rect& centre, const UiState& state);

/// Places the picture and reads what a hand does on it. True while a gesture has the scene in hand.
[[nodiscard]] bool picture_room(UiState& state, const Layout& layout, const UiInput& input);

/// The part of the picture's place in the window that is in sight.
[[nodiscard]] Rect picture_in_sight(const UiState& state);

/// Draws handles, what features lay over the picture, the badge and notifications. After the picture was
/// drawn, so that they agree with it.
void picture_overlay(UiState& state, const Layout& layout);

}  // namespace glint
