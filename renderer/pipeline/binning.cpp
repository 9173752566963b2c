#include "renderer/pipeline/binning.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "renderer/pipeline/clip.h"

namespace glint {
namespace {

constexpr std::uint32_t chunk_size = 8192;  // triangles that one task sorts

/// One chunk more, at the back.
SortedChunk& add_chunk(Geometry& g, std::size_t& count) {
    if (count == g.chunks.size()) g.chunks.emplace_back();  // else as the frame before left it
    return g.chunks[count++];
}

void lay_out_chunks(Geometry& g) {
    std::size_t count = 0;
    for (std::uint32_t o = 0; o < g.objects.size(); ++o) {
        const auto triangles = static_cast<std::uint32_t>(g.objects[o].mesh->triangles.size());
        for (std::uint32_t begin = 0; begin < triangles; begin += chunk_size) {
            SortedChunk& chunk = add_chunk(g, count);
            chunk.object = o;
            chunk.begin = begin;
            chunk.end = std::min(begin + chunk_size, triangles);
        }
    }
    g.chunks.resize(count);
}

SortJob sort_job(const Geometry& g) {
    SortJob job;
    job.width = g.size.width;
    job.height = g.size.height;
    job.margin = g.multisampled ? subpixels / 2 : 0;
    job.clipped_bits = needs_clipping;
    job.beyond_bits = ~std::uint32_t{OutsideGuard};
    return job;
}

/// Calls visit(tile, number) for every triangle of a chunk and every tile that its box meets.
template <class Visit> void visit_tiles(const Geometry& g, const SortedChunk& chunk, const Visit& visit) {
    const auto row = static_cast<std::uint32_t>(g.tiles_x);
    for (std::size_t i = 0; i < chunk.box_count; ++i) {
        const TriangleBox& box = chunk.boxes[i];
        const std::uint32_t x0 = box.tiles & 255u, y0 = box.tiles >> 8 & 255u, x1 = box.tiles >> 16 & 255u;
        for (std::uint32_t y = y0; y <= box.tiles >> 24; ++y)
            for (std::uint32_t x = x0; x <= x1; ++x) visit(y * row + x, box.number);
    }
}

void sort_chunk(const Geometry& g, SortedChunk& chunk) {
    const std::size_t room = std::size_t{chunk.end} - chunk.begin + 1;
    if (chunk.boxes.size() < room) chunk.boxes.resize(room);
    if (chunk.to_clip.size() < room) chunk.to_clip.resize(room);
    SortedTriangles out{chunk.boxes.data(), 0, chunk.to_clip.data(), 0};
    drawing_kernels().sort(chunk.job, chunk.begin, chunk.end, out);
    chunk.box_count = out.box_count;
    chunk.clip_count = out.to_clip_count;
    chunk.next.assign(static_cast<std::size_t>(g.tiles_x) * static_cast<std::size_t>(g.tiles_y), 0);
    visit_tiles(g, chunk, [&chunk](std::uint32_t tile, std::uint32_t) { ++chunk.next[tile]; });
}

/// The clipped pieces as one more chunk. To the kernel they are an object whose every triangle has vertices
/// of its own, four records apart.
void add_pieces(Geometry& g) {
    static_assert(sizeof(ClippedTriangle) == 4 * sizeof(ScreenVertex));
    if (g.clipped.empty()) return;
    const auto count = static_cast<std::uint32_t>(g.clipped.size());
    g.clipped_vertices.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = 0; k < 3; ++k) g.clipped_vertices.push_back(4 * i + k);
    SortedChunk& chunk = g.chunks.emplace_back();
    chunk.end = count;
    chunk.job = sort_job(g);
    chunk.job.triangle_vertices = g.clipped_vertices.data();
    chunk.job.screen = g.clipped.front().corner;
    chunk.job.first_triangle = g.triangle_count;
    sort_chunk(g, chunk);
}

/// Turns each chunk's counts into where its numbers begin, so that the order never depends on threads.
void number_places(Geometry& g) {
    const auto tiles = static_cast<std::size_t>(g.tiles_x) * static_cast<std::size_t>(g.tiles_y);
    g.tile_first.resize(tiles + 1);
    std::uint32_t next = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        g.tile_first[tile] = next;
        for (SortedChunk& chunk : g.chunks) {
            const std::uint32_t count = chunk.next[tile];
            chunk.next[tile] = next;
            next += count;
        }
    }
    g.tile_first[tiles] = next;
    g.tile_triangles.resize(next);
}

}  // namespace

void find_boxes(Geometry& g) {
    g.tiles_x = (g.size.width + tile_size - 1) / tile_size;
    g.tiles_y = (g.size.height + tile_size - 1) / tile_size;
    lay_out_chunks(g);
    tbb::parallel_for(std::size_t{0}, g.chunks.size(), [&g](std::size_t i) {
        SortedChunk& chunk = g.chunks[i];
        const ObjectGeometry& object = g.objects[chunk.object];
        chunk.job = sort_job(g);
        chunk.job.triangle_vertices = object.triangle_vertices.data();
        chunk.job.screen = object.screen.data();
        chunk.job.first_triangle = object.first_triangle;
        sort_chunk(g, chunk);
    });
}

void sort_into_tiles(Geometry& g) {
    add_pieces(g);
    number_places(g);
    tbb::parallel_for(std::size_t{0}, g.chunks.size(), [&g](std::size_t i) {
        SortedChunk& chunk = g.chunks[i];
        visit_tiles(g, chunk, [&g, &chunk](std::uint32_t tile, std::uint32_t number) {
            const std::uint32_t* vertex =
                chunk.job.triangle_vertices + 3 * std::size_t{number - chunk.job.first_triangle};
            g.tile_triangles[chunk.next[tile]++] = {number, {vertex[0], vertex[1], vertex[2]}};
        });
    });
}

}  // namespace glint
