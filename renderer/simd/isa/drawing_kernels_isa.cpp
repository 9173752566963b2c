// The kernels for geometry, visibility and surface, compiled once for each instruction set
// (renderer/CMakeLists.txt, add_kernels). Does not use the standard library, as in lighting_kernels_isa.cpp.

#include "renderer/geometry/transform_lanes.h"
#include "renderer/simd/isa/kernel_set.h"
#include "renderer/simd/wide.h"
#include "renderer/surface/interpolate_group.h"
#include "renderer/visibility/bin_triangles.h"
#include "renderer/visibility/draw_tile.h"

namespace glint::inline GLINT_ISA {

GLINT_FLATTEN static void vertices(const VertexJob& job, std::size_t begin, std::size_t end) {
    transform_all_vertices<Wide>(job, begin, end);
}

GLINT_FLATTEN static void normals(const NormalJob& job, std::size_t begin, std::size_t end) {
    transform_normals<Wide>(job, begin, end);
}

GLINT_FLATTEN static void sort(const BinJob& job, std::uint32_t begin, std::uint32_t end,
                               BinnedTriangles& out) {
    for (std::uint32_t t = begin; t < end; t += GLINT_LANES) bin_lanes<Wide>(job, t, end, out);
}

GLINT_FLATTEN static void draw(const TileJob& job, TilePixels& tile) { draw_tile<Wide>(job, tile); }

GLINT_FLATTEN static void rows(const TilePixels& tile, const TileRows& out) { take_rows<Wide>(tile, out); }

GLINT_FLATTEN static void place(const InterpolateJob& job, const PixelGroup* groups, std::size_t count,
                                PointBlock* out, std::uint8_t* on_fast_path) {
    interpolate_groups<Wide>(job, groups, count, out, on_fast_path);
}

GLINT_FLATTEN static void weigh(const InterpolateJob& job, const PixelGroup* groups, std::size_t count,
                                float* out, std::uint8_t* on_fast_path) {
    weigh_groups<Wide>(job, groups, count, out, on_fast_path);
}

extern const DrawingKernels drawing;
const DrawingKernels drawing{{vertices, normals}, {sort, draw, rows}, {place, weigh}};

}  // namespace glint::inline GLINT_ISA
