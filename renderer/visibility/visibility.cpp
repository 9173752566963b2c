#include "renderer/visibility/visibility.h"

#include "renderer/lighting/light_job.h"
#include "renderer/visibility/rasterize.h"

namespace glint {

SampleOffset sample_offset(int samples, int which) {
    // In sixteenths of a pixel: Direct3D 11's standard patterns, which OpenGL drivers use as well.
    constexpr int two[2][2] = {{4, 4}, {-4, -4}};
    constexpr int four[4][2] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
    constexpr int eight[8][2] = {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
    constexpr int sixteenth = subpixels / 16;
    const auto at = [](const int* p) { return SampleOffset{p[0] * sixteenth, p[1] * sixteenth}; };
    switch (samples) {
    case 2:
        return at(two[which]);
    case 4:
        return at(four[which]);
    case 8:
        return at(eight[which]);
    default:
        return {};
    }
}

bool update_visibility(Visibility& kept, const Geometry& g, Cull cull, int samples, bool geometry_redone) {
    if (!geometry_redone && kept.cull == cull && kept.samples == samples) return false;
    kept.cull = cull;
    kept.samples = samples;
    bin_into_tiles(kept.tiles, g, cull, samples > 1);
    kept.plane = g.size.pixels();
    kept.groups_a_row = (static_cast<std::size_t>(g.size.width) + block_size - 1) / block_size;
    const std::size_t codes = kept.plane * static_cast<std::size_t>(samples);
    const std::size_t tiles = kept.tiles.grid.tile_count();
    const std::size_t groups = kept.groups_a_row * static_cast<std::size_t>(g.size.height);
    if (kept.seen.size() != codes || kept.tile_drawn.size() != tiles || kept.covered.size() != groups) {
        kept.seen.assign(codes, 0);
        kept.covered.assign(groups, 0);
        kept.tile_drawn.assign(tiles, 0);
    }
    rasterize_tiles(g, kept);
    return true;
}

}  // namespace glint
