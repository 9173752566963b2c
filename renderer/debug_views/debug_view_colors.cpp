// The colour scales of debug views.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "renderer/debug_views/debug_view.h"

namespace glint {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

Rgb bytes(glm::dvec3 color) {
    const glm::dvec3 c = glm::clamp(color, 0.0, 1.0) * 255.0 + 0.5;
    return {static_cast<std::uint8_t>(c.x), static_cast<std::uint8_t>(c.y), static_cast<std::uint8_t>(c.z)};
}

/// Interpolates evenly spaced colours at a parameter from 0 to 1.
template <std::size_t N> glm::dvec3 between(const std::array<glm::dvec3, N>& stops, double at) {
    const double scaled = std::clamp(at, 0.0, 1.0) * (N - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(scaled), N - 2);
    return glm::mix(stops[i], stops[i + 1], scaled - static_cast<double>(i));
}

/// Lightness increases evenly, so that the scale also works in greyscale.
const std::array<glm::dvec3, 5> dark_to_light{glm::dvec3(0.06, 0.04, 0.26), glm::dvec3(0.16, 0.26, 0.58),
                                              glm::dvec3(0.12, 0.53, 0.60), glm::dvec3(0.53, 0.78, 0.37),
                                              glm::dvec3(1.00, 0.95, 0.60)};
/// Lit: black, orange, white. Facing away: blues, so that the discontinuity at 0 shows the terminator.
const std::array<glm::dvec3, 3> lit_ramp{glm::dvec3(0.07, 0.04, 0.02), glm::dvec3(0.88, 0.47, 0.10),
                                         glm::dvec3(1, 1, 0.92)};
const std::array<glm::dvec3, 2> unlit_ramp{glm::dvec3(0.10, 0.15, 0.32), glm::dvec3(0.35, 0.62, 1)};

/// Blue and red, as in modelling software.
const glm::dvec3 front_side(0.22, 0.42, 0.95), back_side(0.93, 0.22, 0.20);

}  // namespace

Rgb debug_view_color(DebugView view, const DebugViewScale& scale, double value) {
    if (view == DebugView::NDotL)
        return bytes(value < 0 ? between(unlit_ramp, -value) : between(lit_ramp, value));
    const double share = (value - scale.low) / (scale.high - scale.low);
    // Shows near surfaces in light colours.
    return bytes(between(dark_to_light, view == DebugView::Depth ? 1 - share : share));
}

Rgb normal_color(glm::vec3 normal) { return bytes(glm::dvec3(normal) * 0.5 + 0.5); }

Rgb face_color(std::uint64_t number) {
    const double hue = 6 * std::fmod(static_cast<double>(number) * std::numbers::phi, 1.0);
    const double light = number % 2 == 0 ? 0.92 : 0.66;
    const auto channel = [&](double shift) {
        const double away = std::abs(std::fmod(hue + shift, 6.0) - 3);
        return light * (0.35 + 0.65 * std::clamp(away - 1, 0.0, 1.0));
    };
    return bytes({channel(0), channel(4), channel(2)});
}

Rgb side_color(bool front, double n_dot_v) {
    const double light = 0.55 + 0.45 * std::clamp(std::abs(n_dot_v), 0.0, 1.0);
    return bytes(light * (front ? front_side : back_side));
}

Rgb turned_away_color(Rgb color, int x, int y) {
    if ((x + y) % 8 >= 3) return color;
    return {static_cast<std::uint8_t>(color[0] / 3), static_cast<std::uint8_t>(color[1] / 3),
            static_cast<std::uint8_t>(color[2] / 3)};
}

}  // namespace glint
