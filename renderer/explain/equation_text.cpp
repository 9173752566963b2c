#include "renderer/explain/equation_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "renderer/explain/printed_number.h"

namespace glint {
namespace {

/// Writes one channel of v, or all three if they differ.
template <class Text> std::string in_channels(glm::dvec3 v, std::optional<int> channel, const Text& text) {
    if (channel) return text(v[*channel]);
    const std::string red = text(v.x), green = text(v.y), blue = text(v.z);
    return red == green && green == blue ? red : fmt::format("({} {} {})", red, green, blue);
}

std::string written_factor(const EquationFactor& f, int decimals, int exponent_decimals,
                           std::optional<int> channel) {
    std::string text = f.is_mean ? "mean " + text_of(f.quantity) : text_of(f.quantity);
    if (f.quantity == Quantity::QuarterPi) return text;
    text += ' ';
    if (f.clamped_from < 0) text += short_text(f.clamped_from, decimals) + " → ";
    text += in_channels(f.value, channel, [&](double x) { return short_text(x, decimals); });
    if (!f.power) return text;
    return fmt::format("({})^{}", text, short_text(f.power->exponent, exponent_decimals));
}

/// The minimum number of decimals of a factor. A light's share f is the result of a line of its own, and has
/// as many decimals as there.
int least_decimals(const EquationFactor& f, int channel, NumberText as) {
    const double x = f.value[channel];
    if (f.quantity == Quantity::QuarterPi) return most_decimals;
    if (f.quantity != Quantity::Share) return significant_decimals(x, is_cosine(f.quantity) ? 3 : 2);
    const std::string text = as(x);
    const std::size_t end = std::min(text.find('e'), text.size()), point = std::min(text.find('.'), end);
    return point < end ? static_cast<int>(end - point) - 1 : 0;
}

/// The number of decimals for which the product of the written factors equals the exact product in one
/// channel, to within half of the result's last digit.
LineDecimals decimals_of(const EquationLine& line, int channel, NumberText as) {
    constexpr double held_back = 0.45;  // of the last digit; the rest allows for float rounding
    std::vector<double> values;
    std::vector<int> least;
    for (const EquationFactor& f : line.factors) {
        values.push_back(f.value[channel]);
        values.push_back(f.power ? f.power->exponent : 1);
        least.push_back(least_decimals(f, channel, as));
        least.push_back(0);
    }
    EquationLine written = line;
    const auto formula = [&](std::span<const double> v) {
        for (std::size_t i = 0; i < written.factors.size(); ++i) {
            written.factors[i].value[channel] = v[2 * i];
            if (written.factors[i].power) written.factors[i].power->exponent = v[2 * i + 1];
        }
        return written.product(channel);
    };
    const double result = line.left_out.empty() ? line.result[channel] : line.product(channel);
    const std::vector<int> all = decimals_for(values, least, formula, held_back * last_digit_of(as(result)));
    LineDecimals decimals;
    for (std::size_t i = 0; i < line.factors.size(); ++i) {
        decimals.value.push_back(all[2 * i]);
        decimals.exponent.push_back(all[2 * i + 1]);
    }
    return decimals;
}

/// The larger number of decimals of each factor.
LineDecimals merged(LineDecimals a, const LineDecimals& b) {
    for (std::size_t i = 0; i < a.value.size(); ++i) {
        a.value[i] = std::max(a.value[i], b.value[i]);
        a.exponent[i] = std::max(a.exponent[i], b.exponent[i]);
    }
    return a;
}

}  // namespace

LineDecimals written_decimals(const EquationLine& line, std::optional<int> channel, NumberText as) {
    const auto of = [&](int c) { return decimals_of(line, c, as); };
    return channel ? of(*channel) : merged(merged(of(0), of(1)), of(2));
}

std::string written_product(const EquationLine& line, std::optional<int> channel, NumberText as) {
    const LineDecimals decimals = written_decimals(line, channel, as);
    std::string text;
    for (std::size_t i = 0; i < line.factors.size(); ++i) {
        const EquationFactor& f = line.factors[i];
        if (i > 0) text += f.divides ? " / " : " · ";
        text += written_factor(f, decimals.value[i], decimals.exponent[i], channel);
    }
    if (line.left_out.empty()) return text;
    const glm::dvec3 product{line.product(0), line.product(1), line.product(2)};
    return fmt::format("{} = {}, {}", text, in_channels(product, channel, as), line.left_out);
}

}  // namespace glint
