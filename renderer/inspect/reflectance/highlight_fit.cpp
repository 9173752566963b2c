#include "renderer/inspect/reflectance/highlight_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "renderer/inspect/reflectance/curves.h"

namespace glint {
namespace {

constexpr double most = 10'000;  // the largest shininess that a scene may have

double misfit(Reflection reflection, double shininess, std::span<const glm::dvec2> points) {
    double sum = 0;
    for (const glm::dvec2 p : points) {
        const double away = highlight_at(reflection, static_cast<float>(shininess), p.x) - p.y;
        sum += away * away;
    }
    return sum;
}

}  // namespace

double half_angle_deg(double n) { return n > 0 ? glm::degrees(std::acos(std::exp2(-1 / n))) : 90; }

std::vector<glm::dvec2> highlight_shape(HighlightShape shape, double n, int steps) {
    const double half = half_angle_deg(n);
    std::vector<glm::dvec2> curve;
    for (int i = 0; i <= steps; ++i) {
        const double deg = 90.0 * i / steps, share = deg / half;
        curve.emplace_back(deg, shape == HighlightShape::Gaussian ? std::exp2(-share * share)
                                                                  : std::max(1 - share / 2, 0.0));
    }
    return curve;
}

std::optional<HighlightFit> fitted_highlight(Reflection reflection, std::span<const glm::dvec2> points) {
    if (points.size() < 2) return {};
    // Points that a hand drew may have several valleys: first everywhere, in steps of a tenth of a decade;
    // then thirds of the interval about the best until it is narrow.
    const auto step = [](int i) { return i < 0 ? 0 : std::min(std::pow(10, -1 + 0.1 * i), most); };
    constexpr int last = 50;
    int best = -1;
    double least = misfit(reflection, 0, points);
    for (int i = 0; i <= last; ++i) {
        const double here = misfit(reflection, step(i), points);
        if (here >= least) continue;
        least = here;
        best = i;
    }
    double low = step(best - 1), high = step(std::min(best + 1, last));
    for (int i = 0; i < 60; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (misfit(reflection, a, points) < misfit(reflection, b, points))
            high = b;
        else
            low = a;
    }
    const double shininess = (low + high) / 2;
    return HighlightFit{
        shininess, std::sqrt(misfit(reflection, shininess, points) / static_cast<double>(points.size()))};
}

double blinn_shininess_like(float shininess) {
    std::vector<glm::dvec2> phong;
    for (int deg = 0; deg <= 90; ++deg)
        phong.emplace_back(deg, highlight_at(Reflection::Phong, shininess, deg));
    return fitted_highlight(Reflection::BlinnPhong, phong)->shininess;
}

}  // namespace glint
