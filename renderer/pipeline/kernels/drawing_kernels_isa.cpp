// The kernels of geometry, visibility and surface, compiled once for each instruction set
// (renderer/CMakeLists.txt, add_lighting). No standard library inside, as in lighting/kernels_isa.cpp.

#include "renderer/pipeline/kernels/place_run.h"

namespace glint::inline GLINT_ISA {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GLINT_FLATTEN  // one huge function full of checks would take minutes to compile
#else
#define GLINT_FLATTEN [[gnu::flatten]]
#endif

template <int N> struct NumberOf { using Type = Lanes<N>; };
template <> struct NumberOf<1> { using Type = float; };
using Wide = NumberOf<GLINT_LANES>::Type;

GLINT_FLATTEN static bool place(const PlaceJob& job, const RunFaces& run, PointBlock& out) {
    bool all = true;
    for (std::size_t k = 0; k < block_size; k += GLINT_LANES) all &= place_lanes<Wide>(job, run, k, out);
    return all;
}

extern const DrawingKernels drawing;
const DrawingKernels drawing{place};

}  // namespace glint::inline GLINT_ISA
