#pragma once
// Part of stage 4: while one light alone is dragged, keeps the sum of all the others at each point, and finds
// the pixels that the light can have changed. The picture has the same bits as if every light were added
// anew, because each light's share is rounded to a grid on which sums are exact
// (renderer/lighting/rounding.h).

#include <span>
#include <vector>

#include "models/scene/light.h"
#include "renderer/shade/shade_kernels.h"
#include "renderer/surface/surface.h"

namespace glint {

/// Tells which of 16 groups of pixels have to be coloured again; bit i: group i. The rest are up to date.
struct GroupsToDo {
    unsigned light = 0xFFFF;   // to be lit with the moving light, or with all
    unsigned others_only = 0;  // the moving light no longer reaches them: they show the sum of the others
};

class MovingLight {
  public:
    bool allowed = true;  // false: every light is added anew each time, for measurements

    /// Brings the sums up to date for the light `moving` (index in Scene::lights), the only one that differs
    /// from the frame before; -1: none or several differ. `same_grids`: each object's grid is as it was. No
    /// light is followed where the sum of some object is not exact.
    void follow(int moving, bool same_grids, const std::vector<LightSource>& sources,
                const std::vector<LightJob>& jobs, const Surface& surface);

    [[nodiscard]] bool is_followed() const { return moving_ >= 0; }
    /// One job an object, with the moving light alone. Precondition, here and below: is_followed().
    [[nodiscard]] const std::vector<LightJob>& jobs() const { return jobs_; }
    /// The sums of the other lights, linear RGB, from block `first` of the surface's points on.
    [[nodiscard]] const ColorBlock* others(std::size_t first) const { return &others_[first]; }

    /// Returns what has to be done in the 16 groups from group 16 * `batch` on, and marks it as done. Without
    /// a followed light, all 16 groups have to be done. May be called for several batches at once.
    [[nodiscard]] GroupsToDo groups_to_do(std::size_t batch);
    /// The kept picture is gone: every group has to be coloured again.
    void forget_picture();

  private:
    void split(int moving, const std::vector<LightSource>& sources, const std::vector<LightJob>& jobs);
    void light_others(const std::vector<LightJob>& jobs, const Surface& surface);

    int moving_ = -1;  // index in Scene::lights of the light that is followed; -1: none
    std::vector<LightSource> moving_sources_, other_sources_;
    std::vector<LightJob> jobs_;
    std::vector<ColorBlock> others_;   // #points: the sum of the other lights
    std::vector<BoundsBlock> bounds_;  // of 16 groups each; empty for per-vertex and per-face shading
    // Bit i of word b: the kept picture of group 16 b + i includes light from the moving light. 0xFFFF:
    // unknown, colour it again.
    std::vector<std::uint16_t> shown_lit_;
};

/// The index of the only light that differs, or -1 when none or several do.
[[nodiscard]] int changed_light(const std::vector<Light>& kept, const std::vector<Light>& now);

/// Returns LightJob::grid: the power of two to whose multiples each light's share is rounded, so that the sum
/// is exact. 0, no rounding, where a share has no bound (near a light without constant falloff, an area
/// light, Cook-Torrance), where the bounds are so high that rounding might be seen at this exposure, and for
/// so few lights that keeping a sum would not pay.
[[nodiscard]] float rounding_grid(const LightJob& job, float exposure);

}  // namespace glint
