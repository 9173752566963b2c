#pragma once
// Chooses the instruction set of the kernels: the widest that the processor has, or the one that the
// environment variable GLINT_ISA names (scalar, sse2, avx2, avx512; on ARM scalar, neon), for tests and
// measurements. The picture is the same.

#include <optional>

#include "models/problem.h"

namespace glint {

/// The name of the set in use.
[[nodiscard]] const char* instruction_set_name();

/// Why GLINT_ISA cannot be used: an unknown name, or a set that this processor lacks.
struct InstructionSetProblem {
    Problem problem;
    bool unknown = false;  // the name is unknown; else the processor lacks the set
};
[[nodiscard]] std::optional<InstructionSetProblem> instruction_set_problem();

}  // namespace glint
