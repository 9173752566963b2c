#include "renderer/explain/printed_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace glint {

const char* decimal_format(double x, int decimals) {
    static constexpr std::array plain{"%.0f", "%.1f", "%.2f", "%.3f", "%.4f",
                                      "%.5f", "%.6f", "%.7f", "%.8f", "%.9f"};
    static constexpr std::array powers{"%.0e", "%.1e", "%.2e", "%.3e", "%.4e",
                                       "%.5e", "%.6e", "%.7e", "%.8e", "%.9e"};
    const double size = std::abs(x);
    const bool is_plain = size == 0 || (size >= 1e-4 && size < 1e6);
    return (is_plain ? plain : powers)[static_cast<std::size_t>(std::clamp(decimals, 0, most_decimals))];
}

std::string decimal_text(double x, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, decimal_format(x, decimals), x == 0 ? 0 : x);  // omits the sign of -0
    return text;
}

std::string short_text(double x, int decimals) {
    std::string text = decimal_text(x, decimals);
    const std::size_t end = std::min(text.find('e'), text.size());
    if (text.find('.') >= end) return text;
    std::size_t kept = end;
    while (text[kept - 1] == '0') --kept;
    if (text[kept - 1] == '.') --kept;
    return text.substr(0, kept) + text.substr(end);
}

std::string fixed_text(double x, int decimals) {
    std::string text = fmt::format("{:.{}f}", x, decimals);
    if (text[0] == '-' && text.find_first_not_of("-0.") == text.npos) text.erase(0, 1);
    return text;
}

int significant_decimals(double x, int decimals) {
    const double size = std::abs(x);
    if (!(size >= 1e-4 && size < 1)) return decimals;
    return std::max(decimals, 1 - static_cast<int>(std::floor(std::log10(size))));
}

std::string significant_text(double x, int decimals) {
    if (x != 0 && std::abs(x) < 1e-4) return fmt::format("{:.1e}", x);
    const int needed = significant_decimals(x, decimals);
    std::string text = fixed_text(x, needed);
    for (int i = needed; i > decimals && text.back() == '0'; --i) text.pop_back();
    return text;
}

double last_digit_of(std::string_view number) {
    const std::size_t e = std::min(number.find('e'), number.size());
    const std::size_t point = number.find('.');
    const auto decimals = point < e ? static_cast<int>(e - point) - 1 : 0;
    int exponent = 0;
    if (e < number.size()) {
        const std::size_t digits = number[e + 1] == '+' ? e + 2 : e + 1;  // from_chars rejects a plus
        std::from_chars(number.data() + digits, number.data() + number.size(), exponent);
    }
    return std::pow(10.0, exponent - decimals);
}

std::vector<int> decimals_for(std::span<const double> values, std::span<const int> least,
                              const std::function<double(std::span<const double>)>& formula,
                              double tolerance) {
    std::vector<int> decimals(least.begin(), least.end());
    std::vector<double> numbers(values.begin(), values.end()), error(values.size());
    const double exact = formula(numbers);
    const auto measure = [&](std::size_t i) {
        numbers[i] = std::strtod(decimal_text(values[i], decimals[i]).c_str(), nullptr);
        error[i] = std::abs(formula(numbers) - exact);
        numbers[i] = values[i];
    };
    for (std::size_t i = 0; i < values.size(); ++i) measure(i);
    for (;;) {
        // In the worst case the errors of the numbers add up; products of errors are negligible.
        double sum = 0;
        std::size_t worst = values.size();
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum += error[i];
            if (decimals[i] < most_decimals && (worst == values.size() || error[i] > error[worst])) worst = i;
        }
        if (sum <= tolerance || worst == values.size()) return decimals;
        ++decimals[worst];
        measure(worst);
    }
}

}  // namespace glint
