#pragma once
// All kernels of one instruction set, from its two object files.

#include "renderer/shade/shade_kernels.h"
#include "renderer/surface/surface_kernels.h"

namespace glint {

/// The kernels in drawing_kernels_isa.cpp.
struct DrawingKernels {
    GeometryKernels geometry;
    VisibilityKernels visibility;
    SurfaceKernels surface;
};

/// The kernels in lighting_kernels_isa.cpp.
struct ColorKernels {
    const char* name;  // of the instruction set
    LightingKernels lighting;
    ShadeKernels shade;
};

}  // namespace glint
