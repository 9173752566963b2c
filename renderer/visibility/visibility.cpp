#include "renderer/visibility/visibility.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "models/memory_limit.h"
#include "renderer/geometry/clip.h"
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

/// The lists of a tile's triangles, one for the cell of each level that contains the tile.
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

    /// Draws all lists one after another. Their order does not matter (seen_code).
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

// Sorts triangles into the tiles of the picture that they touch, after clipping and culling. Each tile is
// then drawn by one thread.

namespace {

constexpr std::uint32_t chunk_size = 8192;                // triangles per task
constexpr std::size_t max_pieces = std::size_t{1} << 30;  // their vertices have the numbers 4 i, 4 i + 1, ...

/// Appends a chunk without parts.
BinnedChunk& add_chunk(TileLists& lists, std::size_t& count) {
    if (count == lists.chunks.size())
        lists.chunks.emplace_back();  // otherwise reuses the last frame's memory
    lists.chunks[count].parts.clear();
    return lists.chunks[count++];
}

/// `like`: the values that are the same for the entire picture.
BinJob sort_job(const ObjectGeometry& object, const BinJob& like, Cull cull) {
    BinJob job = like;
    job.triangle_vertices = object.triangle_vertices.data();
    job.screen = object.screen.data();
    job.first_triangle = object.first_triangle;
    if (object.double_sided) return job;
    // Clockwise on the screen is the back, unless the transform mirrors the object.
    job.drop_clockwise = cull == (object.mirrored ? Cull::Front : Cull::Back);
    job.drop_counterclockwise = cull == (object.mirrored ? Cull::Back : Cull::Front);
    return job;
}

/// Divides the triangles into chunks, one per task. A task has a counter for each cell, so small objects
/// share a task. One task per object would require objects x cells counters.
void lay_out_chunks(TileLists& lists, const Geometry& g, const BinJob& like, Cull cull) {
    std::size_t count = 0;
    std::uint32_t room = 0;  // number of triangles that still fit in the last chunk
    for (std::uint32_t o = 0; o < g.objects.size(); ++o) {
        if (!g.objects[o].visible) continue;
        const auto triangles = static_cast<std::uint32_t>(g.objects[o].mesh->triangles.size());
        for (std::uint32_t begin = 0; begin < triangles;) {
            if (room == 0) {
                (void)add_chunk(lists, count);
                room = chunk_size;
            }
            const std::uint32_t end = begin + std::min(room, triangles - begin);
            lists.chunks[count - 1].parts.push_back({o, begin, end, sort_job(g.objects[o], like, cull)});
            room -= end - begin;
            begin = end;
        }
    }
    lists.chunks.resize(count);
}

/// The number of tiles overlapped by a box.
std::uint64_t tiles_of(const TriangleBox& box) {
    return std::uint64_t{box.x1() - box.x0() + 1} * (box.y1() - box.y0() + 1);
}

/// The finest level on which a box overlaps few enough cells.
std::uint32_t level_of(std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1) {
    std::uint32_t level = 0;
    while ((x1 >> level) - (x0 >> level) >= CellGrid::widest ||
           (y1 >> level) - (y0 >> level) >= CellGrid::widest)
        ++level;
    return level;
}

/// Calls visit(cell, box, level) for the boxes begin .. end - 1 of a chunk and every cell that lists them.
template <class Visit>
void visit_cells(const CellGrid& grid, const BinnedChunk& chunk, std::size_t begin, std::size_t end,
                 const Visit& visit) {
    for (std::size_t i = begin; i < end; ++i) {
        const TriangleBox& box = chunk.boxes[i];
        const std::uint32_t x0 = box.x0(), y0 = box.y0(), x1 = box.x1(), y1 = box.y1();
        const std::uint32_t level = level_of(x0, y0, x1, y1), row = grid.row(level);
        for (std::uint32_t y = y0 >> level; y <= y1 >> level; ++y)
            for (std::uint32_t x = x0 >> level; x <= x1 >> level; ++x)
                visit(grid.first[level] + y * row + x, box, level);
    }
}

/// Removes hidden triangles from the entries that a part of a chunk has added to `out`. `before`: `out`
/// before they were added.
void leave_out_hidden(const std::vector<std::uint8_t>& hidden, const ChunkPart& part,
                      const BinnedTriangles& before, BinnedTriangles& out) {
    const std::uint32_t first = part.job.first_triangle;
    const auto boxes_end = std::remove_if(out.boxes + before.box_count, out.boxes + out.box_count,
                                          [&](const TriangleBox& box) { return hidden[box.number] != 0; });
    const auto clip_end = std::remove_if(out.to_clip + before.to_clip_count, out.to_clip + out.to_clip_count,
                                         [&](std::uint32_t t) { return hidden[first + t] != 0; });
    out.box_count = static_cast<std::size_t>(boxes_end - out.boxes);
    out.to_clip_count = static_cast<std::size_t>(clip_end - out.to_clip);
}

/// Finds a chunk's boxes and counts the entries of each cell. `hidden`: as in Visibility.
void bin_chunk(const CellGrid& grid, BinnedChunk& chunk, const std::vector<std::uint8_t>& hidden) {
    std::size_t room = 1;
    for (const ChunkPart& part : chunk.parts) room += part.end - part.begin;
    if (chunk.boxes.size() < room) chunk.boxes.resize(room);
    if (chunk.to_clip.size() < room) chunk.to_clip.resize(room);
    BinnedTriangles out{chunk.boxes.data(), 0, chunk.to_clip.data(), 0};
    for (ChunkPart& part : chunk.parts) {
        const BinnedTriangles before = out;
        visibility_kernels().bin(part.job, part.begin, part.end, out);
        if (!hidden.empty()) leave_out_hidden(hidden, part, before, out);
        part.box_end = out.box_count;
        part.clip_end = out.to_clip_count;
    }
    chunk.next.assign(grid.cell_count(), 0);
    chunk.levels = 0;
    chunk.met = 0;
    for (std::size_t i = 0; i < out.box_count; ++i) chunk.met += tiles_of(chunk.boxes[i]);
    visit_cells(grid, chunk, 0, out.box_count,
                [&chunk](std::uint32_t cell, const TriangleBox&, std::uint32_t level) {
                    ++chunk.next[cell];
                    chunk.levels |= 1u << level;
                });
}

/// Clips a triangle that crosses the near or far plane or leaves the guard band into pieces that do not.
void clip_triangle(TileLists& lists, const Geometry& g, const ObjectGeometry& object, std::uint32_t t) {
    std::vector<glm::dvec4>& polygon = lists.polygon;
    polygon.clear();
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec3& p = object.mesh->positions[object.triangle_vertices[3 * std::size_t{t} + k]];
        // Uses the same two steps as the kernels (transform_lanes.h) to avoid cracks.
        polygon.push_back(g.clip_from_view * (object.view_from_object * glm::dvec4(glm::dvec3(p), 1.0)));
    }
    clip_polygon(polygon, lists.spare_polygon);
    const auto corner = [&g, viewport = viewport_of(g.camera, g.size)](const glm::dvec4& clip) {
        return to_screen(viewport, held_in_view(g.camera.projection, clip));
    };
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        if (lists.clipped.size() == max_pieces)
            throw LimitExceeded({"", "", fmt::format("more than {} triangle pieces are in view", max_pieces),
                                 "fewer triangles that cross the near or far plane"});
        lists.clipped.push_back({{corner(polygon[0]), corner(polygon[i - 1]), corner(polygon[i])},
                                 object.first_triangle + t,
                                 object.mirrored,
                                 object.double_sided});
    }
}

void clip_triangles(TileLists& lists, const Geometry& g) {
    lists.clipped.clear();
    for (const BinnedChunk& chunk : lists.chunks) {
        std::size_t n = 0;
        for (const ChunkPart& part : chunk.parts)
            for (; n < part.clip_end; ++n) clip_triangle(lists, g, g.objects[part.object], chunk.to_clip[n]);
    }
}

/// Adds the clipped pieces as the last chunk. For the kernel they are an object in which every triangle has
/// its own vertices, four records apart. They are culled when they are drawn.
void bin_pieces(TileLists& lists, const Geometry& g, const BinJob& like) {
    static_assert(sizeof(ClippedTriangle) == 4 * sizeof(ScreenVertex));
    const auto count = static_cast<std::uint32_t>(lists.clipped.size());
    lists.clipped_vertices.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = 0; k < 3; ++k) lists.clipped_vertices.push_back(4 * i + k);
    ChunkPart part{0, 0, count, like};
    part.job.triangle_vertices = lists.clipped_vertices.data();
    part.job.screen = count > 0 ? lists.clipped.front().corner : nullptr;
    part.job.first_triangle = g.triangle_count;
    lists.pieces.parts.assign(1, part);
    bin_chunk(lists.grid, lists.pieces, {});  // without hidden triangles, which are not clipped
}

void refuse_too_many_tiles(std::uint64_t met) {
    if (met > max_met_tiles)
        throw LimitExceeded(
            {"", "", fmt::format("the triangles overlap {} tiles of the picture", met),
             fmt::format("at most {}: fewer or smaller triangles, or a smaller picture", max_met_tiles)});
}

/// Converts each chunk's counts to the offsets of its entries in their cells, so the order does not depend on
/// threads. One cell has fewer than 2^31 entries; the total may exceed 2^32.
void number_places(TileLists& lists) {
    std::uint32_t levels = lists.pieces.levels;
    for (const BinnedChunk& chunk : lists.chunks) levels |= chunk.levels;
    lists.cell_first.resize(lists.grid.cell_count() + 1);
    std::size_t first = 0;
    for (std::uint32_t level = 0; level < CellGrid::levels; ++level)
        for (std::uint32_t cell = lists.grid.first[level]; cell < lists.grid.first[level + 1]; ++cell) {
            lists.cell_first[cell] = first;
            if (!(levels >> level & 1u)) continue;
            std::uint32_t place = 0;
            for (BinnedChunk& chunk : lists.chunks) place += std::exchange(chunk.next[cell], place);
            place += std::exchange(lists.pieces.next[cell], place);
            first += place;
        }
    lists.cell_first.back() = first;
    lists.entries.resize(first);
}

void put_into_cells(TileLists& lists, BinnedChunk& chunk) {
    std::size_t begin = 0;
    for (const ChunkPart& part : chunk.parts) {
        const BinJob& job = part.job;
        visit_cells(lists.grid, chunk, begin, part.box_end,
                    [&](std::uint32_t cell, const TriangleBox& box, std::uint32_t) {
                        const std::uint32_t* vertex =
                            job.triangle_vertices + 3 * std::size_t{box.number - job.first_triangle};
                        lists.entries[lists.cell_first[cell] + chunk.next[cell]++] = {
                            box.number, {vertex[0], vertex[1], vertex[2]}};
                    });
        begin = part.box_end;
    }
}

}  // namespace

CellGrid::CellGrid(PictureSize size)
    : tiles_x(static_cast<std::uint32_t>((size.width + tile_size - 1) / tile_size)),
      tiles_y(static_cast<std::uint32_t>((size.height + tile_size - 1) / tile_size)) {
    for (std::uint32_t level = 0; level < levels; ++level)
        first[level + 1] = first[level] + row(level) * (((tiles_y - 1) >> level) + 1);
}

void bin_into_tiles(TileLists& lists, const Geometry& g, Cull cull, bool multisampled,
                    const std::vector<std::uint8_t>& hidden) {
    lists.grid = CellGrid(g.size);
    BinJob like;
    like.width = g.size.width;
    like.height = g.size.height;
    like.margin = multisampled ? subpixels / 2 : 0;
    like.clipped_bits = needs_clipping;
    like.beyond_bits = ~std::uint32_t{OutsideGuard};
    lay_out_chunks(lists, g, like, cull);
    tbb::parallel_for(std::size_t{0}, lists.chunks.size(),
                      [&](std::size_t i) { bin_chunk(lists.grid, lists.chunks[i], hidden); });
    std::uint64_t met = 0;
    for (const BinnedChunk& chunk : lists.chunks) met += chunk.met;
    refuse_too_many_tiles(met);  // clipping alone could take minutes
    clip_triangles(lists, g);
    bin_pieces(lists, g, like);
    refuse_too_many_tiles(met + lists.pieces.met);
    number_places(lists);
    tbb::parallel_for(std::size_t{0}, lists.chunks.size(),
                      [&lists](std::size_t i) { put_into_cells(lists, lists.chunks[i]); });
    put_into_cells(lists, lists.pieces);
}

}  // namespace glint
