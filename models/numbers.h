#pragma once
// Degrees, and numbers as text.

#include <numbers>
#include <string>

namespace glint {

/// One degree in radians.
inline constexpr double degree = std::numbers::pi / 180;

/// The shortest decimals that read back as the same float, as in scene files: "0.1", "-0.0".
[[nodiscard]] std::string number_text(float x);

}  // namespace glint
