#pragma once
// All kernels of one instruction set, from its two object files.

#include <optional>

#include "models/problem.h"
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
    const char* name;  // the name of the instruction set
    LightingKernels lighting;
    ShadeKernels shade;
};

// Selects the instruction set of the kernels: the widest that the processor supports, or the one given by the
// environment variable GLINT_ISA (scalar, sse2, avx2, avx512; on ARM scalar, neon), for tests and
// measurements. All sets give the same picture.

/// The name of the selected set.
[[nodiscard]] const char* instruction_set_name();

/// The reason why GLINT_ISA cannot be used: an unknown name, or a set that this processor does not support.
struct InstructionSetProblem {
    Problem problem;
    bool unknown = false;  // true: the name is unknown; false: the processor does not support the set
};
[[nodiscard]] std::optional<InstructionSetProblem> instruction_set_problem();

}  // namespace glint
