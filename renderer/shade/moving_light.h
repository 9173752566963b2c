#pragma once
// Part of stage 4: while only one light is dragged, caches the sum of all the others at each point, and finds
// the pixels that the light can have changed. The picture has the same bits as if all lights were added
// again, because each light's share is rounded to a grid on which sums are exact
// (renderer/lighting/rounding.h).

#include <span>
#include <vector>

#include "models/scene/light.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/surface/surface.h"

namespace glint {

/// Which of 16 groups of pixels must be coloured again; bit i: group i. The rest are up to date.
struct GroupsToDo {
    unsigned light = 0xFFFF;  // to be lit with the moving light, or with all
    unsigned others_only =
        0;  // groups that the moving light no longer reaches: they show the sum of the others
};

class MovingLight {
  public:
    bool allowed = true;  // false: all lights are added in every frame, for measurements

    /// Updates the sums for the light `moving` (index in Scene::lights), the only one that differs from the
    /// last frame; -1: none or several differ. `same_grids`: each object's grid is unchanged. No light is
    /// followed if the sum of some object is not exact.
    void follow(int moving, bool same_grids, const std::vector<LightSource>& sources,
                const std::vector<LightJob>& jobs, const Surface& surface);

    [[nodiscard]] bool is_followed() const { return moving_ >= 0; }
    /// One job per object, with only the moving light. Precondition, here and below: is_followed().
    [[nodiscard]] const std::vector<LightJob>& jobs() const { return jobs_; }
    /// The sums of the other lights, linear RGB, from block `first` of the surface's points on.
    [[nodiscard]] const ColorBlock* others(std::size_t first) const { return &others_[first]; }

    /// Returns the work in the 16 groups from group 16 * `batch` on, and marks it as done. Without a followed
    /// light, this is all 16 groups. May be called for several batches at once.
    [[nodiscard]] GroupsToDo groups_to_do(std::size_t batch);
    /// The cached picture is invalid: colour every group again.
    void forget_picture();

  private:
    void split(int moving, const std::vector<LightSource>& sources, const std::vector<LightJob>& jobs);
    void light_others(const std::vector<LightJob>& jobs, const Surface& surface);

    int moving_ = -1;  // index in Scene::lights of the followed light; -1: none
    std::vector<LightSource> moving_sources_, other_sources_;
    std::vector<LightJob> jobs_;
    std::vector<ColorBlock> others_;   // #points: the sum of the other lights
    std::vector<BoundsBlock> bounds_;  // of 16 groups each; empty for per-vertex and per-face shading
    // Bit i of word b: the cached picture of group 16 b + i includes light from the moving light. 0xFFFF:
    // unknown, colour it again.
    std::vector<std::uint16_t> shown_lit_;
};

/// The index of the only light that differs, or -1 when none or several do.
[[nodiscard]] int changed_light(const std::vector<Light>& kept, const std::vector<Light>& now);

/// Returns LightJob::grid: the power of two to whose multiples each light's share is rounded, so that the sum
/// is exact. 0, no rounding, if a share has no bound (near a light without constant falloff, an area light,
/// Cook-Torrance), if the bounds are so high that rounding might be visible at this exposure, or if there are
/// too few lights for a cached sum to pay off.
[[nodiscard]] float rounding_grid(const LightJob& job, float exposure);

}  // namespace glint
