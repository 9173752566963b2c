#pragma once
// Chooses the number of digits in an equation, so that the written numbers give the written result.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// The maximum number of decimals. A float does not have more.
inline constexpr int most_decimals = 9;

/// The printf format for x with this many decimals (0 to most_decimals): fixed, or scientific from 1e6 on and
/// below 1e-4.
[[nodiscard]] const char* decimal_format(double x, int decimals);
/// Formats x with that format.
[[nodiscard]] std::string decimal_text(double x, int decimals);
/// decimal_text() without trailing zeros: "0.5", "1".
[[nodiscard]] std::string short_text(double x, int decimals);

/// Formats x with this many decimals. Omits the sign of a number that rounds to 0.
[[nodiscard]] std::string fixed_text(double x, int decimals);
/// Returns the number of decimals that show two significant digits of an x between 0.0001 and 1, at least
/// `decimals`; returns `decimals` for any other x.
[[nodiscard]] int significant_decimals(double x, int decimals);
/// Formats x with `decimals` decimals, or more if needed for two significant digits: "0.00012", "1.2e-05".
[[nodiscard]] std::string significant_text(double x, int decimals);

/// One unit of the last digit of a formatted number: 0.001 of "0.713", 1e-7 of "3.21e-05".
[[nodiscard]] double last_digit_of(std::string_view number);

/// Returns the minimum number of decimals for each of `values`, at least its entry in `least`, for which the
/// formula of the rounded values differs by at most `tolerance` from the formula of the exact values. Returns
/// most_decimals if no number of decimals is sufficient.
[[nodiscard]] std::vector<int> decimals_for(std::span<const double> values, std::span<const int> least,
                                            const std::function<double(std::span<const double>)>& formula,
                                            double tolerance);

}  // namespace glint
