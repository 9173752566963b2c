// While only one light moves, caches the sum of all others and adds the moving light in each frame.
#include "renderer/shade/moving_light.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "models/fields/choices.h"
#include "models/scene/reflection.h"
#include "renderer/lighting/reflection.h"
#include "renderer/shade/lighting.h"

namespace glint {
namespace {

constexpr std::size_t grain = 128;  // blocks per task

/// A bounding sphere of the vectors, out of 16, that belong to pixels. The other vectors are replaced with
/// the first of these.
struct Sphere {
    float x = 0, y = 0, z = 0, radius = 0;

    Sphere(const float* xs, const float* ys, const float* zs, unsigned mask) {
        const auto first = static_cast<std::size_t>(std::countr_zero(mask | 1u << (block_size - 1)));
        std::array<float, block_size> a, b, c;
        for (std::size_t i = 0; i < block_size; ++i) {
            const std::size_t from = mask >> i & 1u ? i : first;
            a[i] = xs[from], b[i] = ys[from], c[i] = zs[from];
            x += a[i], y += b[i], z += c[i];
        }
        constexpr float share = 1.0f / block_size;
        x *= share, y *= share, z *= share;
        float farthest = 0;
        for (std::size_t i = 0; i < block_size; ++i) {
            const float dx = a[i] - x, dy = b[i] - y, dz = c[i] - z;
            farthest = std::max(farthest, dx * dx + dy * dy + dz * dz);
        }
        radius = std::sqrt(farthest);
    }
};

/// Computes the bounds of group i of 16.
void bound_group(BoundsBlock& bounds, std::size_t i, const PointBlock& points, unsigned mask) {
    const Sphere positions(points.x, points.y, points.z, mask);
    const Sphere normals(points.nx, points.ny, points.nz, mask);
    bounds.x[i] = positions.x, bounds.y[i] = positions.y, bounds.z[i] = positions.z;
    bounds.radius[i] = positions.radius;
    bounds.nx[i] = normals.x, bounds.ny[i] = normals.y, bounds.nz[i] = normals.z;
    bounds.spread[i] = normals.radius;
}

/// Computes bounding spheres of the positions and normals of each pixel group. Empty for per-vertex and
/// per-face shading, which have few points to light.
void bound_groups(const Surface& s, std::vector<BoundsBlock>& bounds) {
    const std::size_t groups = s.choice.kind == SurfaceKind::Pixels ? s.groups.size() : 0;
    bounds.resize((groups + block_size - 1) / block_size);
    tbb::parallel_for(std::size_t{0}, bounds.size(), [&](std::size_t n) {
        for (std::size_t r = n * block_size; r < std::min(groups, (n + 1) * block_size); ++r)
            bound_group(bounds[n], r % block_size, s.points[r], s.groups[r].mask);
    });
}

void give_lights(LightJob& job, const std::vector<LightSource>& lights) {
    job.lights = lights.data();
    job.light_count = lights.size();
}

float max_product(const Float3& a, const Float3& b) { return std::max({a.x * b.x, a.y * b.y, a.z * b.z}); }

/// An upper bound of one light's contribution at any point. Infinite for an area light, for which no bound is
/// known.
double max_share(const LightJob& job, const LightSource& light) {
    if (light.is_patch) return HUGE_VAL;
    const SurfaceMaterial& m = job.material;
    const double falloff = light.has_falloff ? 1.0 / light.constant : 1.0;
    return falloff *
           (max_product(m.k_a, light.ambient) + max_diffuse_factor * max_product(m.k_d, light.diffuse) +
            max_specular_factor * max_product(m.k_s, light.specular));
}

}  // namespace

float rounding_grid(const LightJob& job, float exposure) {
    constexpr std::size_t fewest_lights = 3;  // with two lights, caching would save only one of them
    constexpr double coarsest = 0x1p-18;  // relative to white: a hundredth of a level where sRGB is steepest
    const bool bounded = info_of(job.model).is_bounded;
    if (job.light_count < fewest_lights || !bounded || job.bounced || job.tone.on || job.power_table > 0 ||
        job.clamp)
        return 0;
    const SurfaceMaterial& m = job.material;
    const double base = std::max({m.emission.x + m.global_ambient.x, m.emission.y + m.global_ambient.y,
                                  m.emission.z + m.global_ambient.z});
    double most = base, sum = base;
    for (std::size_t i = 0; i < job.light_count; ++i) {
        const double share = max_share(job, job.lights[i]);
        most = std::max(most, share);
        sum += share;
    }
    const double steps = std::max(std::ldexp(most, -22), std::ldexp(sum, -24));  // as rounded() requires
    if (!(steps > 1e-30 && steps < 1e30)) return 0;
    // A light that is far away or falls off quickly may contribute far less than its bound.
    const double grid = std::exp2(std::ceil(std::log2(steps)));
    return grid * double(exposure) <= coarsest ? static_cast<float>(grid) : 0;
}

int changed_light(const std::vector<Light>& kept, const std::vector<Light>& now) {
    int changed = -1;
    if (kept.size() != now.size()) return -1;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (kept[i] == now[i]) continue;
        if (changed >= 0) return -1;
        changed = static_cast<int>(i);
    }
    return changed;
}

void MovingLight::split(int moving, const std::vector<LightSource>& sources,
                        const std::vector<LightJob>& jobs) {
    moving_sources_.clear();
    other_sources_.clear();
    for (const LightSource& s : sources) (s.light == moving ? moving_sources_ : other_sources_).push_back(s);
    jobs_ = jobs;
    for (LightJob& job : jobs_) give_lights(job, moving_sources_);
}

void MovingLight::light_others(const std::vector<LightJob>& jobs, const Surface& s) {
    std::vector<LightJob> other_jobs = jobs;
    for (LightJob& job : other_jobs) give_lights(job, other_sources_);
    others_.resize(s.points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.points.size(), grain), [&](const auto& range) {
        light_blocks(other_jobs, s, range.begin(), range.size(), nullptr, {}, &others_[range.begin()]);
    });
}

void MovingLight::follow(int moving, bool same_grids, const std::vector<LightSource>& sources,
                         const std::vector<LightJob>& jobs, const Surface& surface) {
    // With a mistake, contributions may be so large that the sum depends on the order.
    const bool exact =
        std::all_of(jobs.begin(), jobs.end(), [](const LightJob& j) { return j.grid > 0 && !j.any_mistake; });
    if (!allowed || moving < 0 || !exact) {
        moving_ = -1;
        return;
    }
    split(moving, sources, jobs);
    if (moving_ != moving || !same_grids) {
        light_others(jobs, surface);
        bound_groups(surface, bounds_);
        shown_lit_.assign(bounds_.size(), 0xFFFF);
    }
    moving_ = moving;
}

GroupsToDo MovingLight::groups_to_do(std::size_t batch) {
    if (!is_followed() || bounds_.empty()) return {};
    unsigned lit = 0;  // groups that the moving light may reach
    for (const LightSource& source : moving_sources_) lit |= shade_kernels().find_lit(source, bounds_[batch]);
    const unsigned shown = shown_lit_[batch];
    shown_lit_[batch] = static_cast<std::uint16_t>(lit);
    return {lit, shown & ~lit};
}

void MovingLight::forget_picture() { std::fill(shown_lit_.begin(), shown_lit_.end(), 0xFFFF); }

}  // namespace glint
