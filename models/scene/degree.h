#pragma once

#include <numbers>

namespace glint {

/// One degree in radians.
inline constexpr double degree = std::numbers::pi / 180;

}  // namespace glint
