#pragma once
// What goes into and comes out of the kernels of geometry, visibility and surface: plain numbers, shared by
// all instruction sets.

#include <cstdint>

#include "renderer/lighting/light_job.h"

namespace glint {

/// A vertex as shading needs it: two records of four floats that are read at once.
struct alignas(32) PlacedVertex {
    float clip_x = 0, clip_y = 0, clip_w = 0;  // clip coordinates
    std::uint32_t outside = 0;                 // OutsideBits (clip.h)
    float x = 0, y = 0, z = 0;                 // camera coordinates
    float unused = 0;
};

/// A unit normal in camera coordinates, as a record of four floats.
struct alignas(16) CameraNormal {
    float x = 0, y = 0, z = 0, unused = 0;
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
    float width = 0, height = 0;     // of the picture
    std::uint32_t clipped_bits = 0;  // a vertex with one of these in `outside` needs doubles
};

/// 16 pixels and what they show. Lanes without a pixel repeat another one's.
struct alignas(64) RunFaces {
    std::uint32_t triangle[block_size];        // number within the object
    float at_x[block_size], at_y[block_size];  // the sample, in pixels, y down
    float facing[block_size];                  // -1: the normal is turned round
};

/// The kernels of one instruction set.
struct DrawingKernels {
    /// Places and normals of 16 pixels. False when a lane is none of the usual case: it shows a triangle that
    /// had to be clipped, or its normal is too short to tell; `out` is then of no use.
    bool (*place)(const PlaceJob& job, const RunFaces& run, PointBlock& out);
};

/// Of the same instruction set as lighting_kernels().
const DrawingKernels& drawing_kernels();

}  // namespace glint
