#include "renderer/debug_views/profile.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

/// Point i of `steps` evenly spaced steps from a to b, rounded to the nearest integer.
int on_the_way(int a, int b, int i, int steps) {
    return steps == 0 ? a : a + static_cast<int>(std::lround(static_cast<double>(b - a) * i / steps));
}

void difference(std::vector<ProfileSample>& s) {
    for (std::size_t i = 1; i < s.size(); ++i) s[i].first_difference = s[i].intensity - s[i - 1].intensity;
    for (std::size_t i = 1; i + 1 < s.size(); ++i)
        s[i].second_difference = *s[i + 1].first_difference - *s[i].first_difference;
}

/// The Gaussian-weighted mean of the samples around sample `at`. Near an end of the line, the window is
/// shortened on both sides, so that a linear increase is preserved.
double gaussian_mean(const std::vector<ProfileSample>& samples, std::ptrdiff_t at, double deviation_px,
                     double step_px) {
    const auto last = static_cast<std::ptrdiff_t>(samples.size()) - 1;
    const double wanted = std::ceil(4 * deviation_px / step_px);
    const auto reach =
        static_cast<std::ptrdiff_t>(std::min(wanted, static_cast<double>(std::min(at, last - at))));
    double sum = 0, weights = 0;
    for (std::ptrdiff_t i = -reach; i <= reach; ++i) {
        const double away = static_cast<double>(i) * step_px / deviation_px;
        const double weight = std::exp(-away * away / 2);
        sum += weight * samples[static_cast<std::size_t>(at + i)].intensity;
        weights += weight;
    }
    return sum / weights;
}

double height_of(const SlopeJump& jump) { return std::abs(jump.after - jump.before); }

/// The jump between samples `at` and `at + 1`; their first difference is a mixture of the two slopes.
std::optional<SlopeJump> jump_behind(const std::vector<ProfileSample>& s, std::size_t at) {
    if (at < 2 || at + 3 >= s.size()) return {};
    const auto slope = [&s](std::size_t i) { return *s[i].first_difference; };
    const SlopeJump jump{slope(at), slope(at + 2)};
    const double height = height_of(jump);
    // On a smooth curve, the slope changes by a similar amount between neighbouring samples.
    constexpr double stands_out = 4, rounding = 1e-6;
    const double around =
        std::max(std::abs(slope(at) - slope(at - 1)), std::abs(slope(at + 3) - slope(at + 2)));
    const auto [low, high] = std::minmax(jump.before, jump.after);
    const double margin = 0.01 * height, between = slope(at + 1);
    const bool is_mixture = between >= low - margin && between <= high + margin;
    return is_mixture && height > stands_out * around + rounding ? std::optional(jump) : std::nullopt;
}

std::string field(const std::optional<double>& number) { return number ? fmt::format("{}", *number) : ""; }

}  // namespace

double intensity_of(glm::vec3 c) {
    // Differences relative to green, so that the weights sum to exactly 1 for greys.
    const double r = c.x, g = c.y, b = c.z;
    return g + 0.2126 * (r - g) + 0.0722 * (b - g);
}

std::vector<ProfileSample> profile(const Renderer& renderer, const Picture& picture, glm::ivec2 from,
                                   glm::ivec2 to) {
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    std::vector<ProfileSample> samples(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i) {
        ProfileSample& s = samples[static_cast<std::size_t>(i)];
        s.pixel = {on_the_way(from.x, to.x, i, steps), on_the_way(from.y, to.y, i, steps)};
        s.position = steps == 0 ? 0 : length * i / steps;
        s.color = picture.linear_at(s.pixel.x, s.pixel.y);
        s.intensity = intensity_of(s.color);
        s.seen = renderer.seen_at(s.pixel.x, s.pixel.y);
    }
    difference(samples);
    return samples;
}

std::optional<SlopeJump> slope_jump_at(const std::vector<ProfileSample>& samples, std::size_t at) {
    // The highest jump among overlapping pairs of samples, each of which covers only part of the jump.
    std::optional<SlopeJump> highest;
    bool is_here = false;
    for (std::size_t i = at - std::min<std::size_t>(at, 2); i <= at + 1; ++i) {
        const auto jump = jump_behind(samples, i);
        if (!jump || (highest && height_of(*jump) <= height_of(*highest))) continue;
        highest = jump;
        is_here = i == at || i + 1 == at;
    }
    return is_here ? highest : std::nullopt;
}

std::vector<double> perceived(const std::vector<ProfileSample>& samples, double surround_px) {
    std::vector<double> seen;
    seen.reserve(samples.size());
    const double step_px = samples.size() > 1 ? samples[1].position - samples[0].position : 1;
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(samples.size()); ++i)
        seen.push_back(samples[static_cast<std::size_t>(i)].intensity +
                       gaussian_mean(samples, i, 1, step_px) -
                       gaussian_mean(samples, i, surround_px, step_px));
    return seen;
}

std::string profile_csv(const std::vector<ProfileSample>& samples) {
    std::string csv = "position,r,g,b,intensity,first_difference,second_difference,face,object,x,y\n";
    for (const ProfileSample& s : samples) {
        const std::string face = s.seen ? fmt::format("{},{}", s.seen->face, s.seen->object) : ",";
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", s.position, s.color.x, s.color.y, s.color.z,
                           s.intensity, field(s.first_difference), field(s.second_difference), face,
                           s.pixel.x, s.pixel.y);
    }
    return csv;
}

}  // namespace glint
