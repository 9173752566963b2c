#include "renderer/inspect/reflectance/facet_lobe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "renderer/inspect/reflectance/lobes.h"
#include "renderer/inspect/reflectance/seeded.h"
#include "renderer/lighting/cook_torrance.h"

namespace glint {
namespace {

constexpr int bins = 18;
constexpr double bin_deg = 90.0 / bins, pi = std::numbers::pi;

/// Density of directions l into which facets bounce a ray from v.
double bounced_density(double alpha, glm::dvec3 v, glm::dvec3 l) {
    const glm::dvec3 h = glm::normalize(v + l);
    const double v_dot_h = glm::dot(v, h);
    if (!(v_dot_h > 0) || !(h.z > 0)) return 0;
    const Vec3<float> at{static_cast<float>(h.x), static_cast<float>(h.y), static_cast<float>(h.z)};
    const float d = d_ggx<float>({0, 0, 1}, at, static_cast<float>(alpha));
    return static_cast<double>(d) * h.z / (4 * v_dot_h);
}

/// The integral of bounced_density over the directions between two angles from n.
double expected_share(double alpha, glm::dvec3 v, double from_deg, double to_deg) {
    constexpr int steps = 64, around = 360;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double polar = (from_deg + (to_deg - from_deg) * (i + 0.5) / steps) * pi / 180;
        for (int j = 0; j < around; ++j) {
            const double azimuth = 2 * pi * (j + 0.5) / around;
            const glm::dvec3 l(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                               std::cos(polar));
            sum += bounced_density(alpha, v, l) * std::sin(polar);
        }
    }
    return sum * (2 * pi / around) * ((to_deg - from_deg) * pi / 180 / steps);
}

}  // namespace

glm::dvec3 sampled_normal(double roughness, std::mt19937& random) {
    const double u = uniform(random), azimuth = 2 * pi * uniform(random);
    const double polar = std::atan(ggx_alpha(roughness) * std::sqrt(u / (1 - u)));
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

std::vector<LobeBin> facet_lobe(double roughness, double view_deg, int rays, std::uint32_t seed) {
    const glm::dvec3 v = glm::normalize(glm::dvec3(in_plane(view_deg)));
    std::vector<LobeBin> lobe(bins);
    for (std::size_t i = 0; i < bins; ++i) {
        lobe[i].from_deg = bin_deg * static_cast<double>(i);
        lobe[i].to_deg = lobe[i].from_deg + bin_deg;
        lobe[i].expected = expected_share(ggx_alpha(roughness), v, lobe[i].from_deg, lobe[i].to_deg);
    }
    std::mt19937 random(seed);
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 h = sampled_normal(roughness, random);
        const double v_dot_h = glm::dot(v, h);
        const glm::dvec3 l = 2 * v_dot_h * h - v;
        if (v_dot_h <= 0 || l.z <= 0) continue;
        const double deg = std::acos(std::min(l.z, 1.0)) * 180 / pi;
        lobe[static_cast<std::size_t>(std::min(deg / bin_deg, bins - 0.5))].share += 1.0 / rays;
    }
    return lobe;
}

}  // namespace glint
