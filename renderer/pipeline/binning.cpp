#include "renderer/pipeline/binning.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "renderer/pipeline/clip.h"

namespace glint {
namespace {

constexpr std::uint32_t chunk_size = 8192;  // triangles that one task sorts

/// True for a triangle outside the view, or one that is drawn as clipped pieces instead.
bool is_left_out(const Geometry& g, std::uint32_t number) {
    const std::uint32_t o = g.object_of(number);
    std::uint32_t some = 0, all = ~0u;
    for (const std::uint32_t p : g.position_indices(o, g.triangle(o, number))) {
        some |= g.objects[o].screen[p].outside;
        all &= g.objects[o].screen[p].outside;
    }
    return all || (some & needs_clipping);
}

/// Calls visit(tile, number) for every triangle of one chunk and every tile it may touch.
template <class Visit> void visit_chunk(const Geometry& g, std::uint32_t chunk, const Visit& visit) {
    const PixelBox picture{0, 0, g.size.width - 1, g.size.height - 1};
    const int margin = g.multisampled ? subpixels / 2 : 0;
    const std::uint32_t total = g.triangle_count + static_cast<std::uint32_t>(g.clipped.size());
    const std::uint32_t begin = chunk * chunk_size, end = std::min(begin + chunk_size, total);
    for (std::uint32_t number = begin; number < end; ++number) {
        if (number < g.triangle_count && is_left_out(g, number)) continue;
        const ScreenTriangle s = screen_triangle(g, number);
        const PixelBox box = pixels_of(s.corner, picture, margin);
        if (box.empty() || doubled_area(s.corner) == 0) continue;
        for (int y = box.y0 / tile_size; y <= box.y1 / tile_size; ++y)
            for (int x = box.x0 / tile_size; x <= box.x1 / tile_size; ++x)
                visit(static_cast<std::uint32_t>(y * g.tiles_x + x), number);
    }
}

}  // namespace

PixelBox pixels_of(const std::array<ScreenVertex, 3>& c, const PixelBox& limits, int margin) {
    const auto [min_x, max_x] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [min_y, max_y] = std::minmax({c[0].y, c[1].y, c[2].y});
    // A centre lies at 256 k + 128: the first at or after min, the last at or before max.
    constexpr int half = subpixels / 2;
    return {std::max((min_x - margin + half - 1) >> 8, limits.x0),
            std::max((min_y - margin + half - 1) >> 8, limits.y0),
            std::min((max_x + margin - half) >> 8, limits.x1),
            std::min((max_y + margin - half) >> 8, limits.y1)};
}

void sort_into_tiles(Geometry& g) {
    g.tiles_x = (g.size.width + tile_size - 1) / tile_size;
    g.tiles_y = (g.size.height + tile_size - 1) / tile_size;
    const auto tiles = static_cast<std::uint32_t>(g.tiles_x * g.tiles_y);
    const std::uint32_t total = g.triangle_count + static_cast<std::uint32_t>(g.clipped.size());
    const std::uint32_t chunks = (total + chunk_size - 1) / chunk_size;

    // Count, then fill: each chunk has a slot of its own in each tile, so that the order never depends on
    // threads.
    std::vector<std::uint32_t> slot(std::size_t{chunks} * tiles, 0);
    tbb::parallel_for(0u, chunks, [&](std::uint32_t chunk) {
        std::uint32_t* count = &slot[std::size_t{chunk} * tiles];
        visit_chunk(g, chunk, [count](std::uint32_t tile, std::uint32_t) { ++count[tile]; });
    });
    g.tile_first.assign(tiles + 1, 0);
    std::uint32_t next = 0;
    for (std::uint32_t tile = 0; tile < tiles; ++tile) {
        g.tile_first[tile] = next;
        for (std::uint32_t chunk = 0; chunk < chunks; ++chunk) {
            std::uint32_t& s = slot[std::size_t{chunk} * tiles + tile];
            const std::uint32_t count = s;
            s = next;
            next += count;
        }
    }
    g.tile_first[tiles] = next;
    g.tile_triangles.resize(next);
    tbb::parallel_for(0u, chunks, [&](std::uint32_t chunk) {
        std::uint32_t* at = &slot[std::size_t{chunk} * tiles];
        visit_chunk(g, chunk, [&g, at](std::uint32_t tile, std::uint32_t number) {
            g.tile_triangles[at[tile]++] = number;
        });
    });
}

}  // namespace glint
