#pragma once
// The inputs and outputs of the surface kernels as plain numbers, shared by all instruction sets.

#include "renderer/lighting/light_job.h"
#include "renderer/visibility/visibility_kernels.h"

namespace glint {

/// A blended normal of this length or shorter is degenerate; opposite corner normals can cancel.
inline constexpr float shortest_normal = 1e-6f;

/// Up to 16 adjacent pixels of one row that show the same object.
struct PixelGroup {
    std::uint32_t first_pixel = 0;  // a multiple of 16 in x
    std::uint32_t object = 0;
    std::uint16_t mask = 0;  // bit i: pixel first_pixel + i
};

/// The arrays of one object for looking up the corners of a pixel's triangle.
struct InterpolateJob {
    const TransformedVertex* vertices = nullptr;
    const CameraNormal* normals = nullptr;
    const std::uint32_t* triangle_vertices = nullptr;  // three per triangle
    // Null unless the mesh has more than one normal per vertex. Each triangle's corners (four numbers, the
    // last one unused) and the index of each corner's normal.
    const std::uint32_t* triangle_corners = nullptr;
    const std::uint32_t* corner_normal = nullptr;
    std::uint32_t first_triangle = 0;     // global number of the object's first triangle
    float width = 0, height = 0;          // of the picture
    const std::uint32_t* seen = nullptr;  // seen_code of each pixel of the picture, row by row
    std::uint32_t clipped_bits = 0;  // if `outside` of a vertex contains any of these, doubles are required
    bool two_sided = false;          // whether to reverse the normals of a triangle seen from behind
};

/// The kernels of one instruction set.
struct SurfaceKernels {
    /// Positions and normals of the pixels of `count` groups of one object, one block per group.
    /// on_fast_path[i] = 0 if group i shows a clipped triangle or a degenerate normal; out[i] is then
    /// undefined, and the caller computes it in doubles. Otherwise on_fast_path[i] = 1.
    void (*interpolate)(const InterpolateJob& job, const PixelGroup* groups, std::size_t count,
                        PointBlock* out, std::uint8_t* on_fast_path);
    /// Perspective-correct weights of the three corners of the triangle visible at each pixel: 16 of the
    /// first corner, 16 of the second, 16 of the third, then the next group's. on_fast_path[i] = 0 if group i
    /// shows a clipped triangle, as above.
    void (*weigh)(const InterpolateJob& job, const PixelGroup* groups, std::size_t count, float* out,
                  std::uint8_t* on_fast_path);
};

/// The kernels of the selected instruction set (renderer/simd/isa/kernel_set.h).
const SurfaceKernels& surface_kernels();

}  // namespace glint
