// Chooses the instruction set for the processor at hand, once.

#include <cstdlib>
#include <string>
#include <vector>

#include "renderer/instruction_set.h"
#include "renderer/lighting/light_job.h"

namespace glint {

namespace scalar {
extern const LightingKernels kernels;
}
#ifdef GLINT_X86
namespace sse2 {
extern const LightingKernels kernels;
}
namespace avx2 {
extern const LightingKernels kernels;
}
namespace avx512 {
extern const LightingKernels kernels;
}
#elif defined GLINT_ARM
namespace neon {
extern const LightingKernels kernels;
}
#endif

namespace {

struct Set {
    const LightingKernels* kernels;
    bool usable;  // the processor has it
};

/// From the widest to the narrowest.
std::vector<Set> sets() {
    std::vector<Set> all;
#ifdef GLINT_X86
    all.push_back({&avx512::kernels, __builtin_cpu_supports("avx512f") != 0});
    all.push_back({&avx2::kernels, __builtin_cpu_supports("avx2") != 0});
    all.push_back({&sse2::kernels, true});
#elif defined GLINT_ARM
    all.push_back({&neon::kernels, true});
#endif
    all.push_back({&scalar::kernels, true});
    return all;
}

const LightingKernels& choose() {
    const char* forced = std::getenv("GLINT_ISA");
    const LightingKernels* widest = nullptr;
    for (const Set& set : sets()) {
        if (!set.usable) continue;
        if (forced && std::string(forced) == set.kernels->name) return *set.kernels;
        if (!widest) widest = set.kernels;
    }
    return *widest;
}

}  // namespace

const LightingKernels& lighting_kernels() {
    static const LightingKernels& chosen = choose();
    return chosen;
}

std::optional<InstructionSetProblem> instruction_set_problem() {
    const char* forced = std::getenv("GLINT_ISA");
    if (!forced || !*forced) return std::nullopt;
    const std::string name = forced;
    InstructionSetProblem found{{}, true};
    found.problem.file = "GLINT_ISA";
    found.problem.what = name + " is no instruction set";
    std::string names;
    const std::vector<Set> known = sets();
    for (auto set = known.rbegin(); set != known.rend(); ++set)
        names += (names.empty() ? "" : ", ") + std::string(set->kernels->name);
    found.problem.expected = "one of " + names;
    for (const Set& set : known) {
        if (name != set.kernels->name) continue;
        if (set.usable) return std::nullopt;
        found.unknown = false;
        found.problem.what = "this processor has no " + name;
        found.problem.expected = std::string("a narrower set, or none to have ") + choose().name;
    }
    return found;
}

}  // namespace glint
