#include "renderer/pipeline/rasterize.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace glint {
namespace {

/// Where a tile lies in the picture; at the right and lower border it may reach beyond.
struct TilePlace {
    std::size_t x, y, width, height;  // pixels within the picture
};

/// Puts a tile into one sample's plane of the picture.
void store_tile(const TileRows& tile, const TilePlace& at, std::size_t picture_width, int sample,
                Visibility& out) {
    for (std::size_t y = 0; y < at.height; ++y) {
        const std::size_t pixel = (at.y + y) * picture_width + at.x;
        std::copy_n(tile.seen[y], at.width, &out.seen[static_cast<std::size_t>(sample) * out.plane + pixel]);
        if (out.samples > 1) continue;
        std::uint16_t* covered = &out.covered[(at.y + y) * out.groups_a_row + at.x / block_size];
        for (std::size_t x = 0; x < at.width; x += block_size) {
            const std::size_t beyond = block_size - std::min(block_size, at.width - x);
            covered[x / block_size] =
                static_cast<std::uint16_t>(tile.covered[y][x / block_size] & (0xFFFFu >> beyond));
        }
    }
}

void list_objects(const Geometry& g, std::vector<DrawnObject>& drawn) {
    drawn.clear();
    for (const ObjectGeometry& o : g.objects)
        drawn.push_back({o.screen.data(), o.first_triangle,
                         static_cast<std::uint32_t>(o.mesh->triangles.size()), o.mirrored});
}

}  // namespace

void rasterize_tiles(const Geometry& g, Visibility& out) {
    const TileLists& lists = out.tiles;
    list_objects(g, out.objects);
    const auto width = static_cast<std::size_t>(g.size.width),
               height = static_cast<std::size_t>(g.size.height);
    tbb::parallel_for(std::size_t{0}, out.tile_drawn.size(), [&](std::size_t number) {
        const std::uint32_t first = lists.tile_first[number], count = lists.tile_first[number + 1] - first;
        if (count == 0 && !out.tile_drawn[number]) return;  // background before and now
        out.tile_drawn[number] = count > 0;
        TilePlace at{number % static_cast<std::size_t>(lists.tiles_x) * tile_size,
                     number / static_cast<std::size_t>(lists.tiles_x) * tile_size, 0, 0};
        at.width = std::min<std::size_t>(tile_size, width - at.x);
        at.height = std::min<std::size_t>(tile_size, height - at.y);
        TileJob job;
        job.objects = out.objects.data();
        job.clipped = lists.clipped.data();
        job.triangle_count = g.triangle_count;
        job.entries = lists.entries.data() + first;
        job.count = count;
        job.x0 = static_cast<int>(at.x);
        job.y0 = static_cast<int>(at.y);
        job.draw_front = out.cull != Cull::Front;
        job.draw_back = out.cull != Cull::Back;
        for (int sample = 0; sample < out.samples; ++sample) {
            const SampleOffset offset = sample_offset(out.samples, sample);
            job.offset_x = offset.x;
            job.offset_y = offset.y;
            TilePixels tile;
            drawing_kernels().draw(job, tile);
            TileRows rows;
            drawing_kernels().take_rows(tile, rows);
            store_tile(rows, at, width, sample, out);
        }
    });
}

}  // namespace glint
