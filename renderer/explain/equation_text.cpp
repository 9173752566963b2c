#include "renderer/explain/equation_text.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "models/problem.h"

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

/// The minimum number of decimals of a factor. A light's factor f is the result of another line, and has as
/// many decimals as in that line.
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

namespace {

/// " (4 of 64 samples so far)"; empty for all samples.
std::string so_far(const ExplainedLight& explained, const Light& area) {
    const std::string count = sample_count(explained, area);
    return count.ends_with("so far") ? fmt::format(" ({})", count) : "";
}

bool points_away(const ExplainedPoint& at) { return glm::dot(at.normal.camera, at.view.camera) < 0; }

}  // namespace

bool is_plain_front(const Explanation& explanation) {
    return explanation.front_facing && !points_away(explanation.at);
}

std::string side_words(const Explanation& explanation) {
    const bool away = points_away(explanation.at);
    if (explanation.front_facing) return away ? "front side, n points away from the eye" : "front side";
    return away ? "back side" : "back side, n turned towards the eye";
}

std::string sample_count(const ExplainedLight& explained, const Light& area) {
    const auto side = static_cast<std::size_t>(std::lround(std::sqrt(area.area.samples)));
    const std::size_t count = explained.samples.size(), all = side * side;
    return count < all ? fmt::format("{} of {} samples so far", count, all)
                       : fmt::format("{} samples", count);
}

std::string dark_reason(const ExplainedLight& explained, const Light& light) {
    if (light.kind == LightKind::Area) {
        const auto in_front = std::count_if(explained.samples.begin(), explained.samples.end(),
                                            [](const ExplainedLight& sample) { return sample.n_dot_l > 0; });
        const auto all = static_cast<std::ptrdiff_t>(explained.samples.size());
        if (in_front == 0)
            return std::string("behind the surface: n·l < 0 for all samples") + so_far(explained, light);
        if (explained.reached < 1) {
            const auto reach = std::lround(explained.reached * static_cast<float>(in_front));
            const std::string blocker = on_one_line(explained.blocked_by);
            return (reach == 0 ? "in the shadow of " + blocker
                               : fmt::format("{} of {} samples reach the point; the others are blocked by {}",
                                             reach, in_front, blocker)) +
                   so_far(explained, light);
        }
        if (in_front == all) return {};
        return fmt::format("{} of {} samples are behind the surface", all - in_front, all) +
               so_far(explained, light);
    }
    const bool cone = light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90;
    const bool is_outside = cone && explained.spot_angle_deg > light.spot.cutoff_deg;
    if (is_outside && explained.spot == 0)  // a mistake may widen the cone
        return fmt::format("outside the cone by {:.1f}°", explained.spot_angle_deg - light.spot.cutoff_deg);
    const glm::vec3 added = explained.diffuse + explained.specular;
    const bool adds = std::max({added.r, added.g, added.b}) > grazing_cosine;  // a mistake may light the back
    if (std::abs(explained.n_dot_l) <= grazing_cosine && !adds) return "grazes the surface: n·l = 0";
    if (explained.n_dot_l < 0 && !adds) return "behind the surface: n·l < 0";
    if (explained.reached == 0) return "in the shadow of " + on_one_line(explained.blocked_by);
    const float arrives = light.intensity * explained.falloff;  // a strong light has a long range
    if (arrives < 0.01f && explained.falloff < 0.01f)
        return fmt::format("hardly reaches: falloff {:.2g}", explained.falloff);
    if (arrives * explained.spot < 0.01f && explained.spot < 0.01f)
        return fmt::format("its cone lets through {:.2g}", explained.spot);
    return {};
}

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
