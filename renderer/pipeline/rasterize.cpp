#include "renderer/pipeline/rasterize.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace glint {
namespace {

/// A tile's place in one sample's plane of the picture; at the right and lower border it may reach beyond.
TileRows tile_rows(const TileJob& job, PictureSize size, int sample, Visibility& out) {
    const auto x = static_cast<std::size_t>(job.x0), y = static_cast<std::size_t>(job.y0);
    TileRows rows;
    rows.row = static_cast<std::size_t>(size.width);
    rows.groups_a_row = out.groups_a_row;
    rows.seen = &out.seen[static_cast<std::size_t>(sample) * out.plane + y * rows.row + x];
    if (out.samples == 1) rows.covered = &out.covered[y * rows.groups_a_row + x / block_size];
    rows.width = std::min(tile_size, size.width - job.x0);
    rows.height = std::min(tile_size, size.height - job.y0);
    return rows;
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
    tbb::parallel_for(std::size_t{0}, out.tile_drawn.size(), [&](std::size_t number) {
        const std::uint32_t first = lists.tile_first[number], count = lists.tile_first[number + 1] - first;
        if (count == 0 && !out.tile_drawn[number]) return;  // background before and now
        out.tile_drawn[number] = count > 0;
        TileJob job;
        job.objects = out.objects.data();
        job.clipped = lists.clipped.data();
        job.triangle_count = g.triangle_count;
        job.entries = lists.entries.data() + first;
        job.count = count;
        job.x0 = static_cast<int>(number) % lists.tiles_x * tile_size;
        job.y0 = static_cast<int>(number) / lists.tiles_x * tile_size;
        job.draw_front = out.cull != Cull::Front;
        job.draw_back = out.cull != Cull::Back;
        for (int sample = 0; sample < out.samples; ++sample) {
            const SampleOffset offset = sample_offset(out.samples, sample);
            job.offset_x = offset.x;
            job.offset_y = offset.y;
            TilePixels tile;
            drawing_kernels().draw(job, tile);
            drawing_kernels().take_rows(tile, tile_rows(job, g.size, sample, out));
        }
    });
}

}  // namespace glint
