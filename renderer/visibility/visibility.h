#pragma once
// Stage 2. Finds the triangle visible at each sample: clips and culls triangles, sorts them into tiles, and
// draws them with an exact integer fill rule. The nearest triangle wins; ties go to the object, and then the
// face, with the lower number. Inputs: the geometry and `cull`.

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/simd/pixel_vector.h"
#include "renderer/visibility/visibility_kernels.h"

namespace glint {

// Lists the triangles that may be visible in each tile of the screen: those in view, clipped if necessary.
// Omits culled triangles and triangles without area.

/// The picture's tiles, and larger cells above them: a cell of level L has 2^L x 2^L tiles. A triangle is
/// listed in the cells of the finest level on which its bounding box overlaps at most `widest` cells per
/// side. Even a large triangle therefore has at most 16 entries, and all but the largest are listed in the
/// tiles themselves.
struct CellGrid {
    static constexpr std::uint32_t widest = 4;
    static constexpr std::uint32_t levels = 7;
    static_assert(max_picture_side / tile_size >> (levels - 1) <= static_cast<int>(widest));

    std::uint32_t tiles_x = 0, tiles_y = 0;
    std::array<std::uint32_t, levels + 1> first{};  // for each level, the number of its first cell

    CellGrid() = default;
    explicit CellGrid(PictureSize size);
    [[nodiscard]] std::uint32_t row(std::uint32_t level) const { return ((tiles_x - 1) >> level) + 1; }
    [[nodiscard]] std::uint32_t tile_count() const { return tiles_x * tiles_y; }
    [[nodiscard]] std::uint32_t cell_count() const { return first[levels]; }
    /// The cell of the given level that contains the tile (x, y).
    [[nodiscard]] std::uint32_t cell_at(std::uint32_t level, std::uint32_t x, std::uint32_t y) const {
        return first[level] + (y >> level) * row(level) + (x >> level);
    }
};

/// Consecutive triangles of one object.
struct ChunkPart {
    std::uint32_t object = 0, begin = 0, end = 0;  // triangle numbers within the object
    BinJob job;
    std::size_t box_end = 0, clip_end = 0;  // ends of its parts of the chunk's `boxes` and `to_clip`
};

/// Consecutive triangles binned by one task: of one object, or of several small ones.
struct BinnedChunk {
    std::vector<ChunkPart> parts;
    std::vector<TriangleBox> boxes;      // boxes of triangles that may be visible, ascending
    std::vector<std::uint32_t> to_clip;  // numbers within their objects, ascending
    std::vector<std::uint32_t> next;  // #cells: the index of its next entry in the cell (initially the count)
    std::uint32_t levels = 0;         // bit L: there is an entry in a cell of level L
    std::uint64_t met = 0;            // total number of tiles that the boxes overlap
};

struct TileLists {
    CellGrid grid;
    std::vector<std::size_t> cell_first;   // #cells + 1, into entries
    std::vector<TileEntry> entries;        // ascending numbers within a cell
    std::vector<ClippedTriangle> clipped;  // numbered from Geometry::triangle_count up in the entries
    // Scratch memory, kept to avoid allocations:
    std::vector<BinnedChunk> chunks;                 // cover all triangles, in ascending order
    BinnedChunk pieces;                              // the clipped triangles, binned as one more object
    std::vector<std::uint32_t> clipped_vertices;     // three separate vertices per piece
    std::vector<glm::dvec4> polygon, spare_polygon;  // used while clipping a triangle

    [[nodiscard]] std::size_t count_in_cell(std::uint32_t cell) const {
        return cell_first[cell + 1] - cell_first[cell];
    }
};

/// The maximum total number of tiles that all triangles may overlap. Each is a drawing step, and this many
/// take minutes.
inline constexpr std::uint64_t max_met_tiles = std::uint64_t{1} << 30;

/// Rebuilds the lists, reusing their memory. `multisampled`: samples may be anywhere in their pixels, not
/// only at the centres. `hidden`: as in Visibility. Throws LimitExceeded if the triangles overlap more than
/// max_met_tiles tiles.
void bin_into_tiles(TileLists& lists, const Geometry& geometry, Cull cull, bool multisampled,
                    const std::vector<std::uint8_t>& hidden = {});

struct Visibility {
    Cull cull = Cull::None;
    std::vector<std::uint8_t> hidden;  // #triangles, 1: not drawn; empty: draws all
    PictureSize size{0, 0};            // picture size of `seen`, `covered` and `tile_drawn`
    int samples = 1;  // per pixel: 1, 2, 4 or 8; each sample has its own plane of width x height
    TileLists tiles;
    std::vector<DrawnObject> objects;
    std::size_t plane = 0;            // width x height
    PixelVector<std::uint32_t> seen;  // `samples` planes: seen_code of the nearest triangle; 0: none
    // With one sample per pixel: which pixels in each group of 16 in a row show a triangle, groups_a_row per
    // row.
    std::vector<std::uint16_t> covered;
    std::size_t groups_a_row = 0;
    std::vector<std::uint8_t> tile_drawn;  // 0: the tile is empty, including in `seen` and `covered`

    [[nodiscard]] std::uint32_t triangle_at(std::size_t pixel) const {
        return seen[pixel] ? triangle_of_code(seen[pixel]) : no_triangle;
    }
    /// Whether the visible triangle is clockwise on the screen.
    [[nodiscard]] bool back_at(std::size_t pixel) const { return seen[pixel] && back_of_code(seen[pixel]); }
};

/// The position of sample `which` of `samples` in its pixel, in 1/256 pixel from the centre. A single sample
/// is at the centre. Several samples use the standard rotated grids, so that nearly horizontal and vertical
/// edges get as many steps as there are samples.
struct SampleOffset {
    int x = 0, y = 0;
};
[[nodiscard]] SampleOffset sample_offset(int samples, int which);

/// Runs the stage again if the geometry, `cull`, `samples` or `hidden` has changed; returns whether it did.
/// `hidden`: as in Visibility.
bool update_visibility(Visibility& kept, const Geometry& geometry, Cull cull, int samples,
                       bool geometry_redone, const std::vector<std::uint8_t>& hidden = {});

}  // namespace glint
