#include "renderer/visibility/visibility.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "renderer/lighting/light_job.h"

namespace glint {
namespace {

/// A tile's part of one sample plane of the picture. At the right and lower borders it may extend beyond the
/// picture.
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
                         static_cast<std::uint32_t>(o.mesh->triangles.size()), o.mirrored, o.double_sided});
}

/// The lists of a tile's triangles: those of the cells that contain the tile, on every level.
class CellLists {
  public:
    CellLists(const TileLists& lists, std::uint32_t tile) : lists_(lists) {
        const std::uint32_t x = tile % lists.grid.tiles_x, y = tile / lists.grid.tiles_x;
        for (std::uint32_t level = 0; level < CellGrid::levels; ++level) {
            const std::uint32_t cell = lists.grid.cell_at(level, x, y);
            if (lists.count_in_cell(cell) > 0) cells_[count_++] = cell;
        }
    }
    [[nodiscard]] bool empty() const { return count_ == 0; }

    /// Draws all of them one after another. The order does not matter (seen_code).
    void draw(TileJob job, TilePixels& tile) const {
        std::size_t i = 0;
        do {
            job.keep = i > 0;
            job.entries = count_ > 0 ? lists_.entries.data() + lists_.cell_first[cells_[i]] : nullptr;
            job.count = count_ > 0 ? lists_.count_in_cell(cells_[i]) : 0;
            visibility_kernels().draw(job, tile);
        } while (++i < count_);
    }

  private:
    const TileLists& lists_;
    std::array<std::uint32_t, CellGrid::levels> cells_{};
    std::size_t count_ = 0;
};

void rasterize_tiles(const Geometry& g, Visibility& out) {
    list_objects(g, out.objects);
    tbb::parallel_for(std::uint32_t{0}, out.tiles.grid.tile_count(), [&](std::uint32_t number) {
        const CellLists lists(out.tiles, number);
        if (lists.empty() && !out.tile_drawn[number])
            return;  // background both in the last picture and in this one
        out.tile_drawn[number] = !lists.empty();
        TileJob job;
        job.objects = out.objects.data();
        job.clipped = out.tiles.clipped.data();
        job.triangle_count = g.triangle_count;
        job.x0 = static_cast<int>(number % out.tiles.grid.tiles_x) * tile_size;
        job.y0 = static_cast<int>(number / out.tiles.grid.tiles_x) * tile_size;
        job.draw_front = out.cull != Cull::Front;
        job.draw_back = out.cull != Cull::Back;
        for (int sample = 0; sample < out.samples; ++sample) {
            const SampleOffset offset = sample_offset(out.samples, sample);
            job.offset_x = offset.x;
            job.offset_y = offset.y;
            TilePixels tile;
            lists.draw(job, tile);
            visibility_kernels().take_rows(tile, tile_rows(job, g.size, sample, out));
        }
    });
}

}  // namespace

SampleOffset sample_offset(int samples, int which) {
    // In sixteenths of a pixel: Direct3D 11's standard patterns, which OpenGL drivers also use.
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

bool update_visibility(Visibility& kept, const Geometry& g, Cull cull, int samples, bool geometry_redone,
                       const std::vector<std::uint8_t>& hidden) {
    if (!geometry_redone && kept.cull == cull && kept.samples == samples && kept.hidden == hidden)
        return false;
    const bool same_shape = kept.size == g.size && kept.samples == samples;
    kept.hidden = hidden;
    kept.cull = cull;
    kept.size = g.size;
    kept.samples = samples;
    bin_into_tiles(kept.tiles, g, cull, samples > 1, hidden);
    kept.plane = g.size.pixels();
    kept.groups_a_row = (static_cast<std::size_t>(g.size.width) + block_size - 1) / block_size;
    if (!same_shape) {
        kept.seen.assign(kept.plane * static_cast<std::size_t>(samples), 0);
        kept.covered.assign(kept.groups_a_row * static_cast<std::size_t>(g.size.height), 0);
        kept.tile_drawn.assign(kept.tiles.grid.tile_count(), 0);
    }
    rasterize_tiles(g, kept);
    return true;
}

}  // namespace glint
