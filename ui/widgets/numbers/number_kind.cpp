// Sliders, steps and texts for each kind of number.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "renderer/explain/printed_number.h"
#include "ui/widgets/numbers/number_input.h"

namespace glint {

float lowest(const Range& range) {
    const auto low = static_cast<float>(range.low);
    return range.low_open ? std::nextafter(low, static_cast<float>(range.high)) : low;
}

float highest(const Range& range) {
    const auto high = static_cast<float>(range.high);
    return range.high_open ? std::nextafter(high, static_cast<float>(range.low)) : high;
}

bool has_slider(const Real& kind) {
    return kind.range.low > -max_number && double(kind.usual_max) > kind.range.low;
}

double slider_share(double value, const Real& kind) {
    const double low = kind.range.low, usual = double(kind.usual_max) - low,
                 above = std::max(value - low, 0.0);
    return kind.logarithmic ? std::log1p(above) / std::log1p(usual) : above / usual;
}

double slider_value(double share, const Real& kind) {
    const double low = kind.range.low, usual = double(kind.usual_max) - low;
    const double above = kind.logarithmic ? std::expm1(share * std::log1p(usual)) : share * usual;
    return std::clamp(low + above, double(lowest(kind.range)), double(highest(kind.range)));
}

ImVec4 slider_fill(const Theme& theme, const ImVec4& ground) {
    const auto mix = [](float from, float to) { return from + (to - from) * 0.3f; };
    return {mix(ground.x, theme.accent.x), mix(ground.y, theme.accent.y), mix(ground.z, theme.accent.z), 1};
}

double drag_step(const Real& kind, double value) {
    const double size = kind.logarithmic ? std::max(std::abs(value), 10 * double(kind.step)) : 1;
    const double about = 10 * double(kind.step) * size;
    const double power = std::pow(10, std::floor(std::log10(about)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= about * 0.999) return digit * power;
    return 10 * power;
}

std::string shown_text(float value, const Real& kind) {
    if (value == 0 && *kind.zero != 0) return kind.zero;
    constexpr std::size_t longest = 10;  // characters that fit into a field, so that the end is not cut off
    char plain[64];
    std::snprintf(plain, sizeof plain, kind.format, double(value));
    const std::string_view format = kind.format;
    const bool has_decimals = format.starts_with("%.") && format.substr(3).starts_with('f');
    const std::string text =
        has_decimals ? significant_text(double(value), format[2] - '0').append(format.substr(4)) : plain;
    return text.size() > longest ? fmt::format("{:.6g}", value) : text;
}

std::string fitting_text(float value, const Real& kind, float width) {
    std::string text = shown_text(value, kind);
    constexpr int most_digits = 6;
    for (int digits = most_digits; digits > 0 && ImGui::CalcTextSize(text.c_str()).x > width; --digits)
        text = fmt::format("{:.{}g}", value, digits);
    return text;
}

std::string exact_text(float value) { return fmt::format("{}", value); }

}  // namespace glint
