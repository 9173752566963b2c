#pragma once
// Counted warnings: one line a kind.

#include <fmt/core.h>

#include <cstddef>
#include <string_view>

#include "models/problem.h"

namespace glint {

/// Appends "COUNT one" or "COUNT many" unless the count is 0.
inline void warn(Warnings& warnings, std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) warnings.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
}

}  // namespace glint
