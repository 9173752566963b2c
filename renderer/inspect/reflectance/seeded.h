#pragma once
// Random numbers that are the same on every machine: a generator's bits, not the distributions of std::,
// which differ between libraries.

#include <random>

namespace glint {

/// Uniform in [0, 1).
[[nodiscard]] inline double uniform(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

}  // namespace glint
