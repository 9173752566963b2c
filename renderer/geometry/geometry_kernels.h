#pragma once
// The inputs and outputs of the geometry kernels as plain numbers, shared by all instruction sets.

#include <cstddef>
#include <cstdint>

namespace glint {

inline constexpr int subpixel_bits = 8;
inline constexpr int subpixels = 1 << subpixel_bits;  // steps of the rasterizer's grid per pixel

/// The planes that a vertex is outside of: the six planes of the view volume, and the guard band, beyond
/// which screen coordinates do not fit in the rasterizer's integers or products do not fit in a float.
enum OutsideBits : std::uint32_t {
    OutsideLeft = 1,
    OutsideRight = 2,
    OutsideBottom = 4,
    OutsideTop = 8,
    OutsideNear = 16,
    OutsideFar = 32,
    OutsideGuard = 64
};
inline constexpr std::uint32_t needs_clipping = OutsideNear | OutsideFar | OutsideGuard;

/// The extent of the guard band, in half picture widths: |x|, |y| <= guard_band w. The largest picture has
/// 16384 pixels per side; times 32, times 256 subpixels, that is 2^27, so edge functions easily fit in 64
/// bits.
inline constexpr double guard_band = 64;

/// If w is at least this large, products of two nearby corners' clip coordinates keep a float's precision.
/// For smaller w, positions are computed in doubles.
inline constexpr double min_float_w = 1e-12;

/// A vertex on the rasterizer's grid, y down, with (0, 0) at the picture's upper left corner. Four numbers,
/// loaded together.
struct alignas(16) ScreenVertex {
    std::int32_t x = 0, y = 0;  // 1/256 pixel
    float inv_w = 0;  // depth, linear on the screen, larger is nearer: inv_w_of (vertex_transform.h)
    /// OutsideBits. If one of `needs_clipping` is set, the other members are undefined.
    std::uint32_t outside = 0;
};

/// The vertex data for shading: two records of four numbers, each loaded together.
struct alignas(32) TransformedVertex {
    float clip_x = 0, clip_y = 0, clip_w = 0;  // clip coordinates
    std::uint32_t outside = 0;                 // OutsideBits
    float x = 0, y = 0, z = 0;                 // camera coordinates
    float unused = 0;
};

/// A unit normal, or zero, in camera coordinates: four numbers, loaded together.
struct alignas(16) CameraNormal {
    float x = 0, y = 0, z = 0, unused = 0;
};

/// A 4 x 4 matrix in column-major order.
struct Matrix4 {
    double column[4][4];
};

/// The target picture of the projection (vertex_transform.h).
struct Viewport {
    double width = 0, height = 0;  // pixels
    bool orthographic = false;
};

/// The vertices of one object. Each array has one entry per position.
struct VertexJob {
    const float* positions = nullptr;  // object coordinates, three per vertex
    Matrix4 view_from_object, clip_from_view;
    Viewport viewport;
    TransformedVertex* vertices = nullptr;
    ScreenVertex* on_screen = nullptr;
};

struct Matrix3 {
    double column[3][3];
};
struct NormalJob {
    const float* normals = nullptr;  // object coordinates, three per normal
    Matrix3 matrix;                  // to camera coordinates
    CameraNormal* in_camera = nullptr;
};

/// The kernels of one instruction set.
struct GeometryKernels {
    /// Transforms the vertices begin .. end - 1.
    void (*transform_vertices)(const VertexJob& job, std::size_t begin, std::size_t end);
    /// Transforms and normalizes the normals begin .. end - 1; (0, 0, 0) is unchanged.
    void (*transform_normals)(const NormalJob& job, std::size_t begin, std::size_t end);
};

/// The kernels of the selected instruction set (renderer/simd/isa/kernel_set.h).
const GeometryKernels& geometry_kernels();

}  // namespace glint
