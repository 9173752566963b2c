#pragma once
// The inputs and outputs of the visibility kernels as plain numbers, shared by all instruction sets.

#include "renderer/geometry/geometry_kernels.h"

namespace glint {

inline constexpr int tile_bits = 6;
inline constexpr int tile_size = 1 << tile_bits;  // pixels per side

/// A piece of a clipped triangle.
struct ClippedTriangle {
    ScreenVertex corner[3];
    std::uint32_t triangle = 0;                   // global number of the original triangle
    bool mirrored = false, double_sided = false;  // as for its object (DrawnObject)
};

// Finds the tiles that a triangle may touch.

struct BinJob {
    const std::uint32_t* triangle_vertices = nullptr;  // three per triangle
    const ScreenVertex* screen = nullptr;
    std::uint32_t first_triangle = 0;  // global number of the object's first triangle
    int width = 0, height = 0;         // of the picture
    int margin = 0;                    // in 1/256 pixel; boxes are enlarged by it on every side
    std::uint32_t clipped_bits = 0;    // a triangle with any of these at any corner must be clipped
    std::uint32_t beyond_bits = 0;     // a triangle with any of these at all corners is out of view
    // Culling. Only triangles less than a tile wide and high are culled here, because their areas fit in 32
    // bits. Larger ones are culled when they are drawn.
    bool drop_clockwise = false, drop_counterclockwise = false;
};

/// The tiles x0..x1, y0..y1 (inclusive) that a triangle's bounding box overlaps.
struct TriangleBox {
    std::uint32_t number;  // global number
    std::uint32_t tiles;   // x0, y0, x1, y1, eight bits each, x0 lowest

    /// I: an integer, or a vector of integers.
    template <class I> static constexpr I packed(I x0, I y0, I x1, I y1) {
        return x0 | y0 << 8 | x1 << 16 | y1 << 24;
    }
    [[nodiscard]] std::uint32_t x0() const { return tiles & 255u; }
    [[nodiscard]] std::uint32_t y0() const { return tiles >> 8 & 255u; }
    [[nodiscard]] std::uint32_t x1() const { return tiles >> 16 & 255u; }
    [[nodiscard]] std::uint32_t y1() const { return tiles >> 24; }
};

/// The output of binning. Each array has room for one more entry than there are triangles.
struct BinnedTriangles {
    TriangleBox* boxes = nullptr;
    std::size_t box_count = 0;
    std::uint32_t* to_clip = nullptr;  // numbers within the object
    std::size_t to_clip_count = 0;
};

// Finds the visible triangle at each pixel of a tile.

/// The code of a pixel that shows a triangle; 0: none. Lower numbers have larger codes, so that at equal
/// depth the object, and then the face, with the lower number wins. Numbers are below 2^30. `back`: 1 if the
/// triangle is clockwise on the screen, otherwise 0. I: an integer, or a vector of integers.
template <class I> [[nodiscard]] constexpr I seen_code(I triangle, I back) {
    return 0x7fffffff - ((triangle << 1) + back);
}
template <class I> [[nodiscard]] constexpr I triangle_of_code(I code) { return (0x7fffffff - code) >> 1; }
template <class I> [[nodiscard]] constexpr I back_of_code(I code) { return (0x7fffffff - code) & 1; }

inline constexpr int patch_bits = 2;
inline constexpr int patch_side = 1 << patch_bits;  // pixels per side
inline constexpr int patch_pixels = patch_side * patch_side;
inline constexpr int patches_a_row = tile_size / patch_side;

/// A tile while it is being drawn, in patches of 4 x 4 pixels, so that a small triangle's pixels are close in
/// memory. Patch (px, py) begins at (16 py + px) 16, with its pixels in reading order.
struct alignas(64) TilePixels {
    float inv_w[tile_size * tile_size];
    std::int32_t seen[tile_size * tile_size];  // seen_code
};

/// A triangle in a tile's list: four numbers, loaded together. Includes its vertices, because a lookup in the
/// object's list would cause a cache miss per tile.
struct alignas(16) TileEntry {
    std::uint32_t number;  // global number; clipped pieces start at Geometry::triangle_count
    std::uint32_t vertex[3];
};

/// The destination of a finished tile in the picture: `seen` row by row (seen_code of each pixel), and
/// `covered`, a mask for each 16 pixels (bit i: pixel i shows a triangle).
struct TileRows {
    std::uint32_t* seen = nullptr;          // at the tile's first pixel
    std::uint16_t* covered = nullptr;       // for its first 16 pixels; null: not needed
    std::size_t row = 0, groups_a_row = 0;  // row strides of `seen` and `covered`
    int width = 0, height = 0;              // size of the part inside the picture
};

struct DrawnObject {
    const ScreenVertex* screen = nullptr;
    std::uint32_t first_triangle = 0, triangle_count = 0;
    bool mirrored = false;  // whether the transform reverses the winding
    bool double_sided = false;
};

struct TileJob {
    const DrawnObject* objects = nullptr;  // all objects of the scene
    const ClippedTriangle* clipped = nullptr;
    std::uint32_t triangle_count = 0;    // in all objects; larger numbers are clipped pieces
    const TileEntry* entries = nullptr;  // of the triangles to draw, in ascending order of number
    std::size_t count = 0;
    int x0 = 0, y0 = 0;                        // the tile's first pixel
    int offset_x = 0, offset_y = 0;            // offset of the sample from the pixel's centre, in 1/256 pixel
    bool draw_front = true, draw_back = true;  // double-sided objects are always drawn on both sides
    bool keep = false;                         // true: does not clear the tile first
};

/// The kernels of one instruction set.
struct VisibilityKernels {
    /// Adds the triangles begin .. end - 1 of one object.
    void (*bin)(const BinJob& job, std::uint32_t begin, std::uint32_t end, BinnedTriangles& out);
    /// Draws all of the job's triangles. The result does not depend on their order.
    void (*draw)(const TileJob& job, TilePixels& tile);
    void (*take_rows)(const TilePixels& tile, const TileRows& out);
};

/// The kernels of the selected instruction set (renderer/simd/isa/kernel_set.h).
const VisibilityKernels& visibility_kernels();

}  // namespace glint
