// Selects the instruction set for this processor, once.

#include <cstdlib>
#include <string>
#include <vector>

#include "renderer/simd/isa/kernel_set.h"

namespace glint {

namespace scalar {
extern const ColorKernels colors;
extern const DrawingKernels drawing;
}  // namespace scalar
#ifdef GLINT_X86
namespace sse2 {
extern const ColorKernels colors;
extern const DrawingKernels drawing;
}  // namespace sse2
namespace avx2 {
extern const ColorKernels colors;
extern const DrawingKernels drawing;
}  // namespace avx2
namespace avx512 {
extern const ColorKernels colors;
extern const DrawingKernels drawing;
}  // namespace avx512
#elif defined GLINT_ARM
namespace neon {
extern const ColorKernels colors;
extern const DrawingKernels drawing;
}  // namespace neon
#endif

namespace {

struct Set {
    const ColorKernels* colors;
    const DrawingKernels* drawing;
    bool usable;  // whether the processor supports it
};

/// All sets, from the widest to the narrowest.
std::vector<Set> sets() {
    std::vector<Set> all;
#ifdef GLINT_X86
    all.push_back({&avx512::colors, &avx512::drawing, __builtin_cpu_supports("avx512f") != 0});
    all.push_back({&avx2::colors, &avx2::drawing, __builtin_cpu_supports("avx2") != 0});
    all.push_back({&sse2::colors, &sse2::drawing, true});
#elif defined GLINT_ARM
    all.push_back({&neon::colors, &neon::drawing, true});
#endif
    all.push_back({&scalar::colors, &scalar::drawing, true});
    return all;
}

Set choose() {
    const char* forced = std::getenv("GLINT_ISA");
    Set widest{&scalar::colors, &scalar::drawing, false};
    for (const Set& set : sets()) {
        if (!set.usable) continue;
        if (forced && std::string(forced) == set.colors->name) return set;
        if (!widest.usable) widest = set;
    }
    return widest;
}

const Set& chosen() {
    static const Set set = choose();
    return set;
}

}  // namespace

const GeometryKernels& geometry_kernels() { return chosen().drawing->geometry; }
const VisibilityKernels& visibility_kernels() { return chosen().drawing->visibility; }
const SurfaceKernels& surface_kernels() { return chosen().drawing->surface; }
const LightingKernels& lighting_kernels() { return chosen().colors->lighting; }
const ShadeKernels& shade_kernels() { return chosen().colors->shade; }

const char* instruction_set_name() { return chosen().colors->name; }

std::optional<InstructionSetProblem> instruction_set_problem() {
    const char* forced = std::getenv("GLINT_ISA");
    if (!forced || !*forced) return std::nullopt;
    const std::string name = forced;
    InstructionSetProblem found{{}, true};
    found.problem.file = "GLINT_ISA";
    found.problem.what = name + " is not an instruction set";
    std::string names;
    const std::vector<Set> known = sets();
    for (auto set = known.rbegin(); set != known.rend(); ++set)
        names += (names.empty() ? "" : ", ") + std::string(set->colors->name);
    found.problem.expected = "one of " + names;
    for (const Set& set : known) {
        if (name != set.colors->name) continue;
        if (set.usable) return std::nullopt;
        found.unknown = false;
        found.problem.what = "this processor does not support " + name;
        found.problem.expected =
            std::string("a narrower set, or no value, which selects ") + chosen().colors->name;
    }
    return found;
}

}  // namespace glint
