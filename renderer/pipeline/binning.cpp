#include "renderer/pipeline/binning.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "renderer/pipeline/clip.h"
#include "renderer/pipeline/to_screen.h"

namespace glint {
namespace {

constexpr std::uint32_t chunk_size = 8192;  // triangles that one task sorts

/// One chunk more, at the back.
SortedChunk& add_chunk(TileLists& lists, std::size_t& count) {
    if (count == lists.chunks.size()) lists.chunks.emplace_back();  // else as the frame before left it
    return lists.chunks[count++];
}

/// `like`: what is the same for all of the picture.
SortJob sort_job(const ObjectGeometry& object, const SortJob& like, Cull cull) {
    SortJob job = like;
    job.triangle_vertices = object.triangle_vertices.data();
    job.screen = object.screen.data();
    job.first_triangle = object.first_triangle;
    // Clockwise as seen is the back, unless the transform turned it over.
    job.drop_clockwise = cull == (object.mirrored ? Cull::Front : Cull::Back);
    job.drop_counterclockwise = cull == (object.mirrored ? Cull::Back : Cull::Front);
    return job;
}

void lay_out_chunks(TileLists& lists, const Geometry& g, const SortJob& like, Cull cull) {
    std::size_t count = 0;
    for (std::uint32_t o = 0; o < g.objects.size(); ++o) {
        const auto triangles = static_cast<std::uint32_t>(g.objects[o].mesh->triangles.size());
        for (std::uint32_t begin = 0; begin < triangles; begin += chunk_size) {
            SortedChunk& chunk = add_chunk(lists, count);
            chunk.object = o;
            chunk.begin = begin;
            chunk.end = std::min(begin + chunk_size, triangles);
            chunk.job = sort_job(g.objects[o], like, cull);
        }
    }
    lists.chunks.resize(count);
}

/// Calls visit(tile, number) for every triangle of a chunk and every tile that its box meets.
template <class Visit> void visit_tiles(int tiles_x, const SortedChunk& chunk, const Visit& visit) {
    const auto row = static_cast<std::uint32_t>(tiles_x);
    for (std::size_t i = 0; i < chunk.box_count; ++i) {
        const TriangleBox& box = chunk.boxes[i];
        const std::uint32_t x0 = box.tiles & 255u, y0 = box.tiles >> 8 & 255u, x1 = box.tiles >> 16 & 255u;
        for (std::uint32_t y = y0; y <= box.tiles >> 24; ++y)
            for (std::uint32_t x = x0; x <= x1; ++x) visit(y * row + x, box.number);
    }
}

/// Finds a chunk's boxes, and how many of them each tile meets.
void sort_chunk(const TileLists& lists, SortedChunk& chunk) {
    const std::size_t room = std::size_t{chunk.end} - chunk.begin + 1;
    if (chunk.boxes.size() < room) chunk.boxes.resize(room);
    if (chunk.to_clip.size() < room) chunk.to_clip.resize(room);
    SortedTriangles out{chunk.boxes.data(), 0, chunk.to_clip.data(), 0};
    drawing_kernels().sort(chunk.job, chunk.begin, chunk.end, out);
    chunk.box_count = out.box_count;
    chunk.clip_count = out.to_clip_count;
    chunk.next.assign(static_cast<std::size_t>(lists.tiles_x) * static_cast<std::size_t>(lists.tiles_y), 0);
    visit_tiles(lists.tiles_x, chunk, [&chunk](std::uint32_t tile, std::uint32_t) { ++chunk.next[tile]; });
}

/// Room for so many entries is asked for before it is taken; the rest is what there is already.
void ask_for_room(TileLists& lists, std::uint64_t entries) {
    constexpr std::size_t a_piece = sizeof(ClippedTriangle) + 3 * sizeof(std::uint32_t);
    const std::uint64_t kept = std::max<std::uint64_t>(entries, lists.entries.capacity());
    lists.share.set(
        memory_need(MemoryUse::Tiles, kept * sizeof(TileEntry) + lists.clipped.capacity() * a_piece));
}

/// Cuts the triangles that cross the near or far plane or leave the guard band into pieces that do not.
void clip_triangles(TileLists& lists, const Geometry& g) {
    const glm::dmat4 projection = clip_from_view(g.camera.projection, g.size);
    const ScreenJob screen = screen_job(g.camera, g.size);
    const auto corner = [&screen](const glm::dvec4& clip) { return to_screen(screen, clip); };
    std::vector<glm::dvec4>& polygon = lists.polygon;
    lists.clipped.clear();
    for (const SortedChunk& chunk : lists.chunks) {
        const ObjectGeometry& object = g.objects[chunk.object];
        for (std::size_t n = 0; n < chunk.clip_count; ++n) {
            const std::uint32_t t = chunk.to_clip[n];
            polygon.clear();
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec3& p = object.mesh->positions[object.triangle_vertices[3 * std::size_t{t} + k]];
                polygon.push_back(projection * (object.view_from_object * glm::dvec4(glm::dvec3(p), 1.0)));
            }
            clip_polygon(polygon, lists.spare_polygon);
            for (std::size_t i = 2; i < polygon.size(); ++i)
                lists.clipped.push_back({{corner(polygon[0]), corner(polygon[i - 1]), corner(polygon[i])},
                                         object.first_triangle + t,
                                         object.mirrored});
        }
        if (chunk.clip_count > 0) ask_for_room(lists, 0);
    }
}

/// The clipped pieces as one more chunk, the last. To the kernel they are an object whose every triangle has
/// vertices of its own, four records apart; which of them are culled is found where they are drawn.
void sort_pieces(TileLists& lists, const Geometry& g, const SortJob& like) {
    static_assert(sizeof(ClippedTriangle) == 4 * sizeof(ScreenVertex));
    const auto count = static_cast<std::uint32_t>(lists.clipped.size());
    lists.clipped_vertices.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = 0; k < 3; ++k) lists.clipped_vertices.push_back(4 * i + k);
    SortedChunk& chunk = lists.pieces;
    chunk.end = count;
    chunk.job = like;
    chunk.job.triangle_vertices = lists.clipped_vertices.data();
    chunk.job.screen = count > 0 ? lists.clipped.front().corner : nullptr;
    chunk.job.first_triangle = g.triangle_count;
    sort_chunk(lists, chunk);
}

/// Turns each chunk's counts into where its entries begin, so that the order never depends on threads.
void number_places(TileLists& lists) {
    const auto tiles = static_cast<std::size_t>(lists.tiles_x) * static_cast<std::size_t>(lists.tiles_y);
    lists.tile_first.resize(tiles + 1);
    std::uint32_t next = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        lists.tile_first[tile] = next;
        const auto place = [&next, tile](SortedChunk& chunk) {
            const std::uint32_t count = chunk.next[tile];
            chunk.next[tile] = next;
            next += count;
        };
        std::for_each(lists.chunks.begin(), lists.chunks.end(), place);
        place(lists.pieces);
    }
    lists.tile_first[tiles] = next;
    ask_for_room(lists, next);
    lists.entries.resize(next);
}

void put_into_tiles(TileLists& lists, SortedChunk& chunk) {
    visit_tiles(lists.tiles_x, chunk, [&lists, &chunk](std::uint32_t tile, std::uint32_t number) {
        const std::uint32_t* vertex =
            chunk.job.triangle_vertices + 3 * std::size_t{number - chunk.job.first_triangle};
        lists.entries[chunk.next[tile]++] = {number, {vertex[0], vertex[1], vertex[2]}};
    });
}

}  // namespace

std::uint64_t bytes_to_sort(std::uint64_t triangles, std::uint64_t tiles) {
    const std::uint64_t chunks = (triangles + chunk_size - 1) / chunk_size;
    constexpr std::uint64_t a_triangle = sizeof(TriangleBox) + sizeof(std::uint32_t);
    return (triangles + chunks) * a_triangle + chunks * (sizeof(SortedChunk) + tiles * sizeof(std::uint32_t));
}

void sort_into_tiles(TileLists& lists, const Geometry& g, Cull cull, bool multisampled) {
    lists.tiles_x = (g.size.width + tile_size - 1) / tile_size;
    lists.tiles_y = (g.size.height + tile_size - 1) / tile_size;
    SortJob like;
    like.width = g.size.width;
    like.height = g.size.height;
    like.margin = multisampled ? subpixels / 2 : 0;
    like.clipped_bits = needs_clipping;
    like.beyond_bits = ~std::uint32_t{OutsideGuard};
    lay_out_chunks(lists, g, like, cull);
    tbb::parallel_for(std::size_t{0}, lists.chunks.size(),
                      [&lists](std::size_t i) { sort_chunk(lists, lists.chunks[i]); });
    clip_triangles(lists, g);
    sort_pieces(lists, g, like);
    number_places(lists);
    tbb::parallel_for(std::size_t{0}, lists.chunks.size(),
                      [&lists](std::size_t i) { put_into_tiles(lists, lists.chunks[i]); });
    put_into_tiles(lists, lists.pieces);
}

}  // namespace glint
