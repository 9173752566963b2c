#pragma once
// How many digits a number of an equation is written with: as many as it takes for the written numbers to
// give the written result.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// Most decimals that a number is written with: a float has no more.
inline constexpr int most_decimals = 9;

/// printf's format that writes x with so many decimals (0 to most_decimals): a plain number, or powers of ten
/// from 1e6 on and below 1e-4.
[[nodiscard]] const char* decimal_format(double x, int decimals);
/// x by that format.
[[nodiscard]] std::string decimal_text(double x, int decimals);
/// The same without zeros at the end that say nothing: "0.5", "1".
[[nodiscard]] std::string short_text(double x, int decimals);

/// One unit of the last digit that a number shows: 0.001 of "0.713", 1e-7 of "3.21e-05".
[[nodiscard]] double last_digit_of(std::string_view number);

/// The decimals of each of `values`, each at least its `least` (as many of them), with which what `formula`
/// makes of the written values differs from what it makes of the values themselves by at most `tolerance`. As
/// few as that takes; most_decimals where no number of them is enough.
[[nodiscard]] std::vector<int> decimals_for(std::span<const double> values, std::span<const int> least,
                                            const std::function<double(std::span<const double>)>& formula,
                                            double tolerance);

}  // namespace glint
