// Chooses the instruction set for the processor at hand, once.

#include <cstdlib>
#include <string_view>

#include "renderer/lighting/light_job.h"

namespace glint {

namespace sse2 {
extern const LightingKernels kernels;
}
#ifdef GLINT_HAS_AVX
namespace avx2 {
extern const LightingKernels kernels;
}
namespace avx512 {
extern const LightingKernels kernels;
}
#endif

namespace {

const LightingKernels& choose() {
#ifdef GLINT_HAS_AVX
    const char* forced = std::getenv("GLINT_ISA");
    const std::string_view wanted = forced ? forced : "";
    if (wanted == "sse2") return sse2::kernels;
    if (__builtin_cpu_supports("avx512f") && wanted != "avx2") return avx512::kernels;
    if (__builtin_cpu_supports("avx2")) return avx2::kernels;
#endif
    return sse2::kernels;
}

}  // namespace

const LightingKernels& lighting_kernels() {
    static const LightingKernels& chosen = choose();
    return chosen;
}

}  // namespace glint
