#pragma once
// What goes into and comes out of the kernels of geometry, visibility and surface: plain numbers, shared by
// all instruction sets.

#include <cstddef>
#include <cstdint>

#include "renderer/lighting/light_job.h"

namespace glint {

inline constexpr int tile_size = 64;   // pixels a side
inline constexpr int subpixels = 256;  // the rasteriser's grid, per pixel

/// A vertex on the rasteriser's grid, y down, (0, 0) the picture's upper left corner. Four numbers, read at
/// once.
struct alignas(16) ScreenVertex {
    std::int32_t x = 0, y = 0;  // 1/256 pixel
    float nearness = 0;  // linear on the screen, larger is nearer: 1/w, or (1 - z_ndc)/2 when orthographic
    std::uint32_t outside =
        0;  // OutsideBits (outside_bits.h); with one of `needs_clipping` the rest has no meaning
};

/// A vertex as shading needs it: two records of four numbers, each read at once.
struct alignas(32) PlacedVertex {
    float clip_x = 0, clip_y = 0, clip_w = 0;  // clip coordinates
    std::uint32_t outside = 0;                 // OutsideBits
    float x = 0, y = 0, z = 0;                 // camera coordinates
    float unused = 0;
};

/// A unit normal in camera coordinates, likewise.
struct alignas(16) CameraNormal {
    float x = 0, y = 0, z = 0, unused = 0;
};

/// 4 x 4, column by column.
struct Matrix4 {
    double column[4][4];
};

/// How clip coordinates come onto the grid.
struct ScreenJob {
    double width = 0, height = 0;  // of the picture, pixels
    bool orthographic = false;
};

/// One object's vertices. As many of each as there are positions.
struct VertexJob {
    const float* positions = nullptr;  // object coordinates, three a vertex
    Matrix4 view_from_object, clip_from_view;
    ScreenJob screen;
    PlacedVertex* vertices = nullptr;
    ScreenVertex* on_screen = nullptr;
};

struct Matrix3 {
    double column[3][3];
};
struct NormalJob {
    const float* normals = nullptr;  // object coordinates, three a normal
    Matrix3 matrix;                  // to camera coordinates
    CameraNormal* in_camera = nullptr;
};

/// A piece of a triangle that had to be clipped.
struct ClippedTriangle {
    ScreenVertex corner[3];
    std::uint32_t triangle = 0;  // global number of the triangle it came from
    bool mirrored = false;       // as its object is (DrawnObject)
};

// Which tiles a triangle may touch.

struct SortJob {
    const std::uint32_t* triangle_vertices = nullptr;  // three a triangle
    const ScreenVertex* screen = nullptr;
    std::uint32_t first_triangle = 0;  // global number of the object's first
    int width = 0, height = 0;         // of the picture
    int margin = 0;                    // 1/256 pixel, by which boxes are made larger on every side
    std::uint32_t clipped_bits = 0;    // a triangle with one of these at some corner has to be clipped
    std::uint32_t beyond_bits = 0;     // with one of these at all corners it is out of view
    // Culled: of the triangles less than a tile wide and high, which fit 32 bits; the rest are left to
    // drawing.
    bool drop_clockwise = false, drop_counterclockwise = false;
};

/// The tiles x0..x1, y0..y1 (inclusive) that a triangle's bounding box meets.
struct TriangleBox {
    std::uint32_t number;  // global
    std::uint32_t tiles;   // x0, y0, x1, y1, eight bits each, x0 the lowest
};

/// Room for one entry a triangle, and one more.
struct SortedTriangles {
    TriangleBox* boxes = nullptr;
    std::size_t box_count = 0;
    std::uint32_t* to_clip = nullptr;  // numbers within the object
    std::size_t to_clip_count = 0;
};

// Which triangle is seen at each pixel of a tile.

/// What a pixel holds that shows a triangle; 0 shows none. Larger for lower numbers, so that at equal depth
/// the lower object and then the lower face wins by being larger. Numbers below 2^30.
[[nodiscard]] constexpr std::uint32_t seen_code(std::uint32_t triangle, bool back) {
    return 0x7fffffffu - (2 * triangle + (back ? 1u : 0u));
}
[[nodiscard]] constexpr std::uint32_t triangle_of_code(std::uint32_t code) {
    return (0x7fffffffu - code) >> 1;
}
/// True where the triangle is wound clockwise as seen.
[[nodiscard]] constexpr bool is_back(std::uint32_t code) { return (0x7fffffffu - code) & 1u; }

inline constexpr int patch_side = 4;  // pixels
inline constexpr int patch_pixels = patch_side * patch_side;
inline constexpr int patches_a_row = tile_size / patch_side;

/// A tile while it is drawn, in patches of 4 x 4 pixels, so that what a small triangle covers lies together:
/// patch (px, py) begins at (16 py + px) 16, its pixels in reading order.
struct alignas(64) TilePixels {
    float nearness[tile_size * tile_size];
    std::int32_t seen[tile_size * tile_size];  // seen_code
};

/// A triangle in a tile's list: four numbers, read at once. With its vertices, because looking them up in the
/// object's list would wait for memory once for each tile.
struct alignas(16) TileEntry {
    std::uint32_t number;  // global; from Geometry::triangle_count on that of a clipped piece
    std::uint32_t vertex[3];
};

/// Where a tile goes in the picture: what its pixels show (as in TilePixels) row by row, and which pixels of
/// each 16 show a triangle, bit i the pixel i.
struct TileRows {
    std::uint32_t* seen = nullptr;          // of the tile's first pixel
    std::uint16_t* covered = nullptr;       // of its first 16; null: not wanted
    std::size_t row = 0, groups_a_row = 0;  // from one row to the next in either
    int width = 0, height = 0;              // of what lies within the picture
};

struct DrawnObject {
    const ScreenVertex* screen = nullptr;
    std::uint32_t first_triangle = 0, triangle_count = 0;
    bool mirrored = false;  // the transform turns the winding over
};

struct TileJob {
    const DrawnObject* objects = nullptr;  // all of the scene
    const ClippedTriangle* clipped = nullptr;
    std::uint32_t triangle_count = 0;    // of all objects; larger numbers are clipped pieces
    const TileEntry* entries = nullptr;  // of the triangles to draw, numbers rising
    std::size_t count = 0;
    int x0 = 0, y0 = 0;              // the tile's first pixel
    int offset_x = 0, offset_y = 0;  // of the sample from the pixel's centre, in 1/256 pixel
    bool draw_front = true, draw_back = true;
    bool keep = false;  // what the tile shows already stays, else it is cleared first
};

// What the pixels show.

/// Up to 16 neighbouring pixels of one row that show the same object.
struct PixelRun {
    std::uint32_t first_pixel = 0;  // a multiple of 16 in x
    std::uint32_t object = 0;
    std::uint16_t mask = 0;  // bit i: pixel first_pixel + i
};

/// One object, as the pixels that show it look their corners up.
struct PlaceJob {
    const PlacedVertex* vertices = nullptr;
    const CameraNormal* normals = nullptr;
    const std::uint32_t* triangle_vertices = nullptr;  // three a triangle
    // Where one normal a vertex does not suffice, else null: each triangle's corners (four numbers, the last
    // without use) and each corner's normal.
    const std::uint32_t* triangle_corners = nullptr;
    const std::uint32_t* corner_normal = nullptr;
    std::uint32_t first_triangle = 0;     // global number of the object's first
    float width = 0, height = 0;          // of the picture
    const std::uint32_t* seen = nullptr;  // seen_code of each of its pixels, row by row
    std::uint32_t clipped_bits = 0;       // a vertex with one of these in `outside` needs doubles
    bool two_sided = false;               // a triangle seen from behind has its normals turned round
};

/// The kernels of one instruction set.
struct DrawingKernels {
    /// The vertices begin .. end - 1.
    void (*place_vertices)(const VertexJob& job, std::size_t begin, std::size_t end);
    /// The normals begin .. end - 1, made unit; (0, 0, 0) stays so.
    void (*place_normals)(const NormalJob& job, std::size_t begin, std::size_t end);
    /// Adds the triangles begin .. end - 1 of one object.
    void (*sort)(const SortJob& job, std::uint32_t begin, std::uint32_t end, SortedTriangles& out);
    /// Draws all of the job's triangles; what a tile shows in the end does not depend on their order.
    void (*draw)(const TileJob& job, TilePixels& tile);
    void (*take_rows)(const TilePixels& tile, const TileRows& out);
    /// Places and normals of the pixels of `count` runs of one object, a block a run. usual[i] becomes 0
    /// where a pixel of run i is none of the usual case: it shows a triangle that had to be clipped, or its
    /// normal is too short to tell; the block is then of no use. Else 1.
    void (*place)(const PlaceJob& job, const PixelRun* runs, std::size_t count, PointBlock* out,
                  std::uint8_t* usual);
};

/// Of the same instruction set as lighting_kernels().
const DrawingKernels& drawing_kernels();

}  // namespace glint
