#pragma once
// Draws the picture when needed, at the largest size that time permits.

#include <memory>
#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"
#include "ui/commands/keys.h"
#include "ui/document/job.h"
#include "ui/picture/screen.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

// Keeps a drag smooth: if a full picture takes too long, draws smaller ones during a motion, and the full one
// as soon as the motion stops. A state machine of its own: milliseconds in, a divisor out.

/// A full-size picture that takes longer than this is drawn smaller during a motion.
inline constexpr double slow_picture_ms = 33;

struct FramePace {
    double slow_ms = slow_picture_ms;  // infinite while nothing is dragged
    int divisor = 1;                   // divides the width and height of the next picture
    double full_ms = 0;                // time of a full-size picture, measured or estimated
    bool in_vain = false;              // smaller pictures are not faster: the time is spent elsewhere
    double rests_since = 0;            // time of the last change, seconds on the caller's clock
    int drawn_at = 0;  // divisor of the picture drawn in this frame; 0: none was drawn, or no motion
};

/// Smaller pictures are chosen to take about this.
inline constexpr double wanted_picture_ms = 24;
inline constexpr int largest_divisor = 4;
/// A motion ends after this many seconds without a change; then the full picture is drawn.
inline constexpr double rest_before_full = 0.15;

/// Called when a gesture ends: the next picture is a full one.
void end_of_motion(FramePace& pace);

/// Updates the estimate after a picture drawn at `divisor` in `ms` during a motion.
void picture_took(FramePace& pace, int divisor, double ms);

/// `full` divided by `divisor`, each side at least 1.
[[nodiscard]] PictureSize divided(PictureSize full, int divisor);

/// Pixels of a picture, from `low` to `high`, exclusive.
struct PartRect {
    glm::ivec2 low{0}, high{0};
    [[nodiscard]] bool holds(glm::ivec2 p) const {
        return p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y;
    }
};

/// A part of the displayed picture, and its relation to the edited scene.
struct ShownPart {
    PartRect rect;
    const Renderer* renderer = nullptr;  // renderer that drew it; null: drawn by another program
    const Scene* other = nullptr;        // the scene in it, if its objects differ from those of the drawn one
    bool has_effects = true;             // highlights and terminators are where the edited scene has them
};

/// The part that contains a pixel of the displayed picture; null: none.
[[nodiscard]] const ShownPart* part_at(const UiState& state, glm::ivec2 pixel);

/// Whether both scenes show the same surfaces in the same pixels of a picture, with the same indices: camera,
/// objects, meshes and transforms are equal. Lights, materials and shading may differ.
[[nodiscard]] bool same_surfaces(const Scene& a, const Scene& b);

// Bounced light and the shadows of area lights are refined in the background while nothing changes: a job
// traces more rays in a second renderer, which then replaces the first. So every picture has one consistent
// number of rays, and can be explained.

class Refinement {
  public:
    /// Draws a scene that has changed: with few rays, unless a picture with more of them is kept. `passes`:
    /// it is a preview; afterwards the previous scene returns with all its rays.
    const Picture& begin(Renderer& renderer, const Scene& scene, PictureSize size, bool linear, bool passes);
    /// Starts and collects jobs, once a frame. Returns the picture when one with more rays is ready.
    const Picture* advance(Renderer& renderer, Jobs& jobs, int threads);
    /// The share of the scene's rays that have been traced, 0 to 1; 1 when the picture has all of them.
    [[nodiscard]] float progress() const;

  private:
    struct Wanted {
        Scene scene;
        PictureSize size;
        bool linear = false;
        bool operator==(const Wanted&) const = default;
    };
    void exchange(Renderer& renderer);

    std::optional<Wanted> wanted_, kept_;  // the picture of the renderer, and of the second one
    int rays_ = 0, kept_rays_ = 0;         // the maximum from each of their points
    std::shared_ptr<Renderer> spare_;      // the second renderer: used by the job, or idle
    JobPtr<int> job_, ending_;
    bool passing_ = false, failed_ = false;
    double since_ = 0;  // time of the last change, ImGui time
};

/// A thin bar at the lower edge of the picture while `progress` is below 1.
void draw_refinement(ImDrawList& list, const PictureView& view, float progress);

/// Returns the renderer whose last picture identifies the open scene's items at each pixel. Null if that
/// picture has another size, or shows other surfaces: the scene has been changed by keys since, or the
/// picture is a preview of another scene. Hovering, picking and dragging use this function, so that they
/// never get the index of an object that does not exist.
[[nodiscard]] const Renderer* renderer_of_open_scene(const UiState& state, PictureSize size);

/// Draws the shown scene (edited or preview) if it or the size differs from the last picture; then explains
/// the picked pixel, except during a preview. During a drag, a picture that would take too long is drawn
/// smaller.
void draw_picture(UiState& state, const PictureView& view);

/// Records how long the pictures of this frame took, including the parts of a comparison.
void learn_pace(UiState& state);

// The picture's area in the middle of the window: the picture, the mouse on it, and its overlays.

/// Keeps overlays on the same scene point when the aspect ratio, and so the field of view, changes. A point
/// outside the picture is kept until the picture is wide enough again.
void follow_shape(UiState& state, PictureSize size);

/// The picture's position and its size in real pixels.
[[nodiscard]] PictureView picture_view(const Rect& centre, const UiState& state);

/// Places the picture and handles the mouse on it. True while a gesture edits the scene.
[[nodiscard]] bool picture_room(UiState& state, const Layout& layout, const UiInput& input);

/// The visible part of the picture's area in the window.
[[nodiscard]] Rect picture_in_sight(const UiState& state);

/// Draws handles, overlays of features, the badge and notifications. After the picture is drawn, so that they
/// agree with it.
void picture_overlay(UiState& state, const Layout& layout);

}  // namespace glint
