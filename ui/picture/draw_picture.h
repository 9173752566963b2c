#pragma once
// Draws the picture when needed, at the largest size that the available time permits.

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"
#include "ui/commands/keys.h"
#include "ui/document/job.h"
#include "ui/picture/screen.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

// Keeps a drag smooth: if a full picture takes too long, draws smaller ones during motion, and the full one
// as soon as the motion stops. This is a state machine: milliseconds in, a divisor out.

/// If a full-size picture takes longer than this, smaller ones are drawn during motion.
inline constexpr double slow_picture_ms = 33;

struct FramePace {
    double slow_ms = slow_picture_ms;  // infinity while nothing is being dragged
    int divisor = 1;                   // divides the width and height of the next picture
    double full_ms = 0;                // time of a full-size picture, measured or estimated
    bool in_vain = false;              // smaller pictures are not faster, because the time is spent elsewhere
    double rests_since = 0;            // time of the last change, in seconds on the caller's clock
    int drawn_at =
        0;  // divisor of the picture drawn in this frame; 0 if none was drawn or nothing is in motion
};

/// The size of smaller pictures is chosen so that each takes about this long.
inline constexpr double wanted_picture_ms = 24;
inline constexpr int largest_divisor = 4;
/// A motion ends after this many seconds without a change. Then the full picture is drawn.
inline constexpr double rest_before_full = 0.15;

/// Called when a gesture ends: the next picture has full size.
void end_of_motion(FramePace& pace);

/// Updates the estimate after a picture that was drawn at `divisor` during motion and took `ms`.
void picture_took(FramePace& pace, int divisor, double ms);

/// Returns `full` divided by `divisor`; each side is at least 1.
[[nodiscard]] PictureSize divided(PictureSize full, int divisor);

/// Pixels of a picture, from `low` up to but excluding `high`.
struct PartRect {
    glm::ivec2 low{0}, high{0};
    [[nodiscard]] bool holds(glm::ivec2 p) const {
        return p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y;
    }
};

/// A part of the displayed picture, and its relation to the edited scene.
struct ShownPart {
    PartRect rect;
    const Renderer* renderer = nullptr;  // the renderer that drew the part; null: another program drew it
    const Scene* other = nullptr;        // the part's scene, if its objects differ from the drawn scene's
    bool has_effects = true;             // highlights and terminators are where the edited scene has them
};

/// Returns the part that contains a pixel of the displayed picture; null: none.
[[nodiscard]] const ShownPart* part_at(const UiState& state, glm::ivec2 pixel);

/// Whether the two scenes show the same surfaces in the same pixels of a picture, with the same indices:
/// their cameras, objects, meshes and transforms are equal. Lights, materials and shading may differ.
[[nodiscard]] bool same_surfaces(const Scene& a, const Scene& b);

// Bounced light and the shadows of area lights are refined in the background while nothing changes: a job
// traces more rays in a second renderer, which then replaces the first. So every picture has one consistent
// number of rays, and can be explained.

class Refinement {
  public:
    /// Draws a scene that has changed: with few rays, unless a picture of it with more rays has been kept.
    /// `passes`: it is a preview; when it ends, the previous scene returns with all its rays.
    const Picture& begin(Renderer& renderer, const Scene& scene, PictureSize size, bool linear, bool passes);
    /// Starts and collects jobs. Called once per frame. Returns a picture when one with more rays is ready.
    const Picture* advance(Renderer& renderer, Jobs& jobs, int threads);
    /// The fraction of the scene's rays that have been traced, 0 to 1; 1 when the picture has all of them.
    [[nodiscard]] float progress() const;

  private:
    struct Wanted {
        Scene scene;
        PictureSize size;
        bool linear = false;
        bool operator==(const Wanted&) const = default;
    };
    void exchange(Renderer& renderer);

    std::optional<Wanted> wanted_, kept_;  // the pictures in the first and in the second renderer
    int rays_ = 0, kept_rays_ = 0;         // the maximum number of rays per point in each
    std::shared_ptr<Renderer> spare_;      // the second renderer: used by the job, or idle
    JobPtr<int> job_, ending_;
    bool passing_ = false, failed_ = false;
    double since_ = 0;  // ImGui time of the last change
};

/// Draws a thin bar at the lower edge of the picture while `progress` is below 1.
void draw_refinement(ImDrawList& list, const PictureView& view, float progress);

/// Returns the renderer whose last picture identifies the open scene's items at each pixel. Null if that
/// picture has a different size or shows different surfaces: keys have changed the scene since then, or the
/// picture is a preview of another scene. Hovering, picking and dragging use this function, so that they
/// never get the index of an object that does not exist.
[[nodiscard]] const Renderer* renderer_of_open_scene(const UiState& state, PictureSize size);

/// Draws the shown scene (edited or preview) if it or the size differs from the last picture; then explains
/// the picked pixel, except during a preview. During a drag, draws a smaller picture if a full one would take
/// too long.
void draw_picture(UiState& state, const PictureView& view);

/// Records how long the pictures of this frame took, including the parts of a comparison.
void learn_pace(UiState& state);

// The picture's area at the centre of the window: the picture, mouse input on it, and its overlays.

/// Keeps overlays on the same scene point when the aspect ratio, and so the field of view, changes. A point
/// outside the picture is kept until the picture is wide enough again.
void follow_shape(UiState& state, PictureSize size);

/// Returns the picture's position and its size in physical pixels.
[[nodiscard]] PictureView picture_view(const Rect& centre, const UiState& state);

/// Positions the picture and handles mouse input on it. True while a gesture is editing the scene.
[[nodiscard]] bool picture_room(UiState& state, const Layout& layout, const UiInput& input);

/// Returns the visible part of the picture's area in the window.
[[nodiscard]] Rect picture_in_sight(const UiState& state);

/// Draws handles, the features' overlays, the badge and notifications. Called after the picture is drawn, so
/// that they agree with it.
void picture_overlay(UiState& state, const Layout& layout);

// The surface at a few pixels around a centre, and the slope of a quantity there.

/// The surfaces of a picture, seen by its camera. The renderer's last picture must show the scene through
/// `map`.
struct SurfaceView {
    const Scene& scene;
    const Renderer& renderer;
    const ScreenMap& map;
    const Dome& dome;
};

/// Returns the surface point at a position in the last picture, which must have this size; nullopt outside
/// the picture or on the background.
[[nodiscard]] std::optional<SeenPoint> seen_at(const Renderer& renderer, PictureSize size, glm::dvec2 pixel);

/// A square of 2 radius + 1 pixels per side, row by row. Pixels that do not show the same surface as the
/// centre (another object, a part farther away, the far side of a crease) are not used; in `points` the
/// centre replaces them.
struct SurfacePatch {
    int radius = 0;
    std::vector<SeenPoint> points;
    std::vector<bool> used;

    [[nodiscard]] const SeenPoint& middle() const { return points[points.size() / 2]; }
    /// The offset from the centre, in pixels.
    [[nodiscard]] glm::dvec2 offset(std::size_t i) const;
    /// Gradient at the centre of ln(values), per pixel, from pairs of opposite pixels up to `within` pixels
    /// from the centre horizontally and vertically, so that curvature cancels. 0 if undefined. Values of 0
    /// are not used.
    [[nodiscard]] glm::dvec2 slope_of_log(const std::vector<double>& values, int within) const;
    /// Length of the gradient at the centre of a patch of radius 1, per pixel; 0 if undefined.
    [[nodiscard]] double steepness(const std::function<double(const SeenPoint&)>& value) const;
    /// Distance of the largest value from the centre, in pixels; among equal values, the nearest counts.
    /// `radius` + 1 if the centre is 0.
    [[nodiscard]] double distance_of_maximum(const std::vector<double>& values) const;
};

/// Returns the patch around a pixel; nullopt on the background.
[[nodiscard]] std::optional<SurfacePatch> surface_patch(const Renderer& renderer, PictureSize size,
                                                        glm::dvec2 pixel, int radius);

}  // namespace glint
