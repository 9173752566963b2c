#pragma once
// Which triangles may be seen in which tile of the screen: those in view, clipped where they must be, without
// the ones that are culled or have no area.

#include "models/memory_limit.h"
#include "renderer/pipeline/geometry.h"

namespace glint {

/// Neighbouring triangles of one object, which one task sorts.
struct SortedChunk {
    std::uint32_t object = 0, begin = 0, end = 0;  // triangles, numbers within the object
    SortJob job;
    std::vector<TriangleBox> boxes;      // box_count, of those that may be seen, rising
    std::vector<std::uint32_t> to_clip;  // clip_count numbers within the object, rising
    std::size_t box_count = 0, clip_count = 0;
    std::vector<std::uint32_t>
        next;  // #tiles: where in TileLists::entries its next one goes (first: how many)
};

struct TileLists {
    int tiles_x = 0, tiles_y = 0;
    std::vector<std::uint32_t> tile_first;  // #tiles + 1, into entries
    std::vector<TileEntry> entries;         // numbers rising within a tile
    std::vector<ClippedTriangle> clipped;   // numbered Geometry::triangle_count and on in the entries
    // What they were made of.
    std::vector<SortedChunk> chunks;  // of all triangles, in rising order
    SortedChunk pieces;               // of the clipped ones: to sorting they are one more object, with
    std::vector<std::uint32_t> clipped_vertices;     // three vertices each of their own
    std::vector<glm::dvec4> polygon, spare_polygon;  // while a triangle is clipped
    MemoryShare share;                               // of the entries and the clipped triangles
};

/// Bytes that sorting takes of an object of so many triangles, whatever its place, in a picture of so many
/// tiles.
[[nodiscard]] std::uint64_t bytes_to_sort(std::uint64_t triangles, std::uint64_t tiles);

/// Makes the lists anew in the memory of the old ones; throws MemoryRefused where they do not fit.
/// `multisampled`: for samples anywhere in their pixels, not at the centres alone.
void sort_into_tiles(TileLists& lists, const Geometry& geometry, Cull cull, bool multisampled);

}  // namespace glint
