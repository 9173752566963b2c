#pragma once
// Writes a line of the equation as one line of text, with as many digits as its result needs.

#include <optional>
#include <string>
#include <vector>

#include "renderer/explain/equation_line.h"

namespace glint {

/// Formats the result of a line; the digits of the factors follow from it.
using NumberText = std::string (*)(double);

/// The number of decimals of each number in a line (renderer/explain/printed_number.h).
struct LineDecimals {
    std::vector<int> value, exponent;  // one per factor
};

/// The number of decimals for which the factors give the result as written by `as`, for one channel or for
/// all three.
[[nodiscard]] LineDecimals written_decimals(const EquationLine& line, std::optional<int> channel,
                                            NumberText as);

/// "f 1.5 · L_d 1 · k_d (0.8 0.1 0.1) · n·l 0.871", "(n·h 0.953)^32 = 0.2144, dropped: n·l < 0". Writes one
/// channel, or all three with factors in brackets if their channels differ.
[[nodiscard]] std::string written_product(const EquationLine& line, std::optional<int> channel,
                                          NumberText as);

}  // namespace glint
