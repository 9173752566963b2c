#pragma once
// Part of stage 4. While only one light is dragged, caches the sum of all others at each point, and finds the
// pixels that the light may have changed. The picture is bit-identical to adding all lights again, because
// each light's contribution is rounded to a grid on which sums are exact (renderer/lighting/surface_point.h).

#include <span>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/surface/surface.h"

namespace glint {

/// Which of 16 groups of pixels must be recomputed. Bit i: group i. All others are up to date.
struct GroupsToDo {
    unsigned light = 0xFFFF;  // to be lit with the moving light, or with all lights
    unsigned others_only =
        0;  // groups that the moving light no longer reaches; they show the sum of the others
};

class MovingLight {
  public:
    bool allowed = true;  // false: adds all lights in every frame, for measurements

    /// Updates the sums for the light `moving` (index in Scene::lights), the only one that has changed since
    /// the last frame; -1: none or several have changed. `same_grids`: each object's grid is unchanged. Does
    /// not follow a light if the sum of any object is not exact.
    void follow(int moving, bool same_grids, const std::vector<LightSource>& sources,
                const std::vector<LightJob>& jobs, const Surface& surface);

    [[nodiscard]] bool is_followed() const { return moving_ >= 0; }
    /// One job per object, with only the moving light. Precondition of this and the following function:
    /// is_followed().
    [[nodiscard]] const std::vector<LightJob>& jobs() const { return jobs_; }
    /// The sums of the other lights, linear RGB, starting at block `first` of the surface's points.
    [[nodiscard]] const ColorBlock* others(std::size_t first) const { return &others_[first]; }

    /// Returns which of the 16 groups, starting at group 16 * `batch`, must be recomputed, and marks them as
    /// up to date. Without a followed light these are all 16 groups. Thread-safe for different batches.
    [[nodiscard]] GroupsToDo groups_to_do(std::size_t batch);
    /// Invalidates the cached picture: all groups will be recomputed.
    void forget_picture();

  private:
    void split(int moving, const std::vector<LightSource>& sources, const std::vector<LightJob>& jobs);
    void light_others(const std::vector<LightJob>& jobs, const Surface& surface);

    int moving_ = -1;  // index in Scene::lights of the followed light, or -1
    std::vector<LightSource> moving_sources_, other_sources_;
    std::vector<LightJob> jobs_;
    std::vector<ColorBlock> others_;   // #points: the sums of the other lights
    std::vector<BoundsBlock> bounds_;  // each for 16 groups; empty for per-vertex and per-face shading
    // Bit i of word b: the cached picture of group 16 b + i includes light from the moving light. 0xFFFF:
    // unknown, so the groups must be recomputed.
    std::vector<std::uint16_t> shown_lit_;
};

/// The index of the only light that has changed, or -1 if none or several have.
[[nodiscard]] int changed_light(const std::vector<Light>& kept, const std::vector<Light>& now);

/// Returns LightJob::grid: the power of two to multiples of which each light's contribution is rounded, so
/// that the sum is exact. 0, meaning no rounding, if a contribution has no bound (near a light without
/// constant falloff, an area light, Cook-Torrance), if the bounds are so high that rounding might be visible
/// at this exposure, or if there are too few lights for caching to pay off.
[[nodiscard]] float rounding_grid(const LightJob& job, float exposure);

}  // namespace glint
