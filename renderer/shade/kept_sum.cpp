#include "renderer/shade/kept_sum.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "renderer/shade/light_points.h"
#include "renderer/shade/point_bounds.h"

namespace glint {
namespace {

constexpr std::size_t grain = 128;  // blocks a task

/// Splits the lights into the one that moves and the others.
void split_lights(Lighting& l, int moving) {
    l.moving_sources.clear();
    l.other_sources.clear();
    for (const LightSource& s : l.sources)
        (s.light == moving ? l.moving_sources : l.other_sources).push_back(s);
    l.moving_jobs = l.jobs;
    for (LightJob& job : l.moving_jobs) {
        job.lights = l.moving_sources.data();
        job.light_count = l.moving_sources.size();
    }
}

/// Lights every point with all lights but the moving one.
void light_others(Lighting& l, const Surface& s) {
    std::vector<LightJob> jobs = l.jobs;
    for (LightJob& job : jobs) {
        job.lights = l.other_sources.data();
        job.light_count = l.other_sources.size();
    }
    l.others.resize(s.points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.points.size(), grain), [&](const auto& range) {
        light_blocks(jobs, s, range.begin(), range.size(), nullptr, &l.others[range.begin()]);
    });
}

/// Without room for the sums every light is lit every time, which gives the same picture.
bool has_room(Lighting& l, const Surface& s) {
    constexpr std::size_t bounds = sizeof(ReachBlock) + sizeof(std::uint16_t);
    try {
        l.share.set(
            memory_need(MemoryUse::Pixels, s.points.size() * (sizeof(ColorBlock) + bounds / block_size)));
    } catch (const Refused&) {
        return false;
    }
    return true;
}

}  // namespace

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

void keep_others(Lighting& l, const Surface& s, int moving, bool same_grids) {
    const bool exact =
        std::all_of(l.jobs.begin(), l.jobs.end(), [](const LightJob& j) { return j.grid > 0; });
    if (!l.keep_sums || moving < 0 || !exact || !has_room(l, s)) {
        l.moving = -1;
        return;
    }
    split_lights(l, moving);
    if (l.moving != moving || !same_grids) {
        light_others(l, s);
        bound_pixels(s, l.reach);
        l.shown_lit.assign(l.reach.size(), 0xFFFF);
    }
    l.moving = moving;
}

}  // namespace glint
