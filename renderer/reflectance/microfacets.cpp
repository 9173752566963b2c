#include "renderer/reflectance/microfacets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "models/numbers.h"
#include "renderer/lighting/reflection.h"
#include "renderer/reflectance/lobes.h"

namespace glint {
namespace {

glm::dvec2 direction(double deg) { return {std::sin(deg * degree), std::cos(deg * degree)}; }

/// A normally distributed number with mean 0 and deviation 1. Box and Muller 1958.
double normal(std::mt19937& random) {
    const double u = 1 - uniform(random), v = uniform(random);
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

double random_tilt(std::mt19937& random, double sigma_deg) {
    for (;;) {
        const double tilt = sigma_deg * normal(random);
        if (std::abs(tilt) <= steepest_deg) return tilt;
    }
}

/// Creates the facets one after another. The distribution of tilts is symmetric, so their signs are
/// arbitrary. If the height deviates too far from 0, the sign is chosen to move it back.
void make_profile(MicrofacetPicture& p, const MicrofacetOptions& options, std::mt19937& random) {
    glm::dvec2 at(0);
    p.profile.push_back(at);
    const double band = 2 * std::tan(std::min(p.sigma_deg, 45.0) * degree);
    for (int i = 0; i < options.facets; ++i) {
        double tilt = random_tilt(random, p.sigma_deg);
        if (std::abs(at.y) > band) tilt = std::copysign(tilt, at.y);  // a positive tilt slopes downwards
        at += glm::dvec2(1, -std::tan(tilt * degree));
        p.profile.push_back(at);
        p.tilt_deg.push_back(tilt);
    }
}

/// The first intersection of the ray from `start` on facet `from` with another facet; nullopt if there is
/// none.
std::optional<glm::dvec2> meets(const MicrofacetPicture& p, int from, glm::dvec2 start, glm::dvec2 d,
                                double highest) {
    const int step = d.x < 0 ? -1 : 1, end = static_cast<int>(p.tilt_deg.size());
    if (std::abs(d.x) < 1e-12) return std::nullopt;  // straight up; there are no overhangs
    for (int i = from + step; i >= 0 && i < end; i += step) {
        const glm::dvec2 a = p.profile[static_cast<std::size_t>(i)],
                         b = p.profile[static_cast<std::size_t>(i) + 1];
        const glm::dvec2 near = step > 0 ? a : b, far = step > 0 ? b : a;
        const double slope = d.y / d.x;
        const double above_near = start.y + (near.x - start.x) * slope - near.y;
        const double above_far = start.y + (far.x - start.x) * slope - far.y;
        if (above_far < 0) {
            const double t = std::clamp(above_near / (above_near - above_far), 0.0, 1.0);
            return near + t * (far - near);
        }
        if (d.y > 0 && start.y + (far.x - start.x) * slope > highest) return std::nullopt;
    }
    return std::nullopt;
}

/// Traces one ray to a point on a facet that faces the light.
FacetRay trace(const MicrofacetPicture& p, int facet, double along, double light_deg, double highest) {
    FacetRay ray;
    ray.facet = facet;
    const glm::dvec2 a = p.profile[static_cast<std::size_t>(facet)];
    const glm::dvec2 b = p.profile[static_cast<std::size_t>(facet) + 1];
    const glm::dvec2 l = direction(-light_deg);
    ray.at = a + along * (b - a);
    ray.from = ray.at + ((highest - ray.at.y) / l.y + 2) * l;
    const double tilt = p.tilt_deg[static_cast<std::size_t>(facet)];
    const double out = 2 * tilt + light_deg;  // equal angles to the normal
    ray.out_deg = out > 180 ? out - 360 : out < -180 ? out + 360 : out;
    if (const auto stopped = meets(p, facet, ray.at, l, highest)) {
        ray.fate = RayFate::Shadowed;
        ray.at = ray.to = *stopped;
        return ray;
    }
    const glm::dvec2 d = direction(ray.out_deg);
    const auto stopped = meets(p, facet, ray.at, d, highest);
    ray.to = stopped ? *stopped : ray.at + 4.0 * d;
    if (d.y <= 0)
        ray.fate = RayFate::Inward;
    else if (stopped)
        ray.fate = RayFate::Masked;
    return ray;
}

/// Aims parallel rays, as from a distant lamp, at the facets in the middle half, in proportion to the width
/// of each facet as seen from the light.
void aim_rays(MicrofacetPicture& p, const MicrofacetOptions& options, std::mt19937& random) {
    const int first = options.facets / 4, last = options.facets - first;
    std::vector<double> shown{0};  // running sum
    for (int i = first; i < last; ++i) {
        const double tilt = p.tilt_deg[static_cast<std::size_t>(i)];
        const double width = std::cos((options.light_deg + tilt) * degree) / std::cos(tilt * degree);
        shown.push_back(shown.back() + std::max(width, 0.0));
    }
    if (!(shown.back() > 0)) return;  // no facet faces the light
    double highest = p.profile.front().y;
    for (const glm::dvec2& point : p.profile) highest = std::max(highest, point.y);
    for (int i = 0; i < options.rays; ++i) {
        const double place = shown.back() * (i + uniform(random)) / options.rays;
        const auto above = std::upper_bound(shown.begin(), shown.end() - 1, place);
        const double low = *(above - 1), along = std::clamp((place - low) / (*above - low), 0.0, 1.0);
        const int facet = first + static_cast<int>(above - shown.begin()) - 1;
        p.rays.push_back(trace(p, facet, along, options.light_deg, highest));
    }
}

void count_rays(MicrofacetPicture& p) {
    const double share = 1.0 / static_cast<double>(std::max<std::size_t>(p.rays.size(), 1));
    p.histogram.assign(histogram_bins, 0);
    for (const FacetRay& ray : p.rays) {
        switch (ray.fate) {
        case RayFate::Shadowed:
            p.shadowed += share;
            break;
        case RayFate::Masked:
            p.masked += share;
            break;
        case RayFate::Inward:
            p.inward += share;
            break;
        case RayFate::Free:
            p.free += share;
            p.histogram[static_cast<std::size_t>(std::clamp((ray.out_deg + 90) / 5, 0.0, 35.5))] += share;
            break;
        }
    }
}

/// The density of tilts per degree: normal with deviation sigma_deg, truncated at steepest_deg. sigma_deg >
/// 0.
double tilt_density(double sigma_deg, double tilt_deg) {
    if (std::abs(tilt_deg) > steepest_deg) return 0;
    const double kept = std::erf(steepest_deg / (sigma_deg * std::numbers::sqrt2));
    const double x = tilt_deg / sigma_deg;
    return std::exp(-x * x / 2) / (sigma_deg * std::sqrt(2 * std::numbers::pi) * kept);
}

/// The fraction of tilts within `half_width` of the given tilt, by the midpoint rule.
double share_of_tilts(double sigma_deg, double tilt_deg, double half_width) {
    constexpr int steps = 64;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        sum += tilt_density(sigma_deg, tilt_deg + half_width * ((2 * i + 1.0) / steps - 1));
    return sum * 2 * half_width / steps;
}

void find_shining(MicrofacetPicture& p, const MicrofacetOptions& options) {
    p.h_deg = (options.view_deg - options.light_deg) / 2;
    for (std::size_t i = 0; i < p.tilt_deg.size(); ++i)
        if (std::abs(p.tilt_deg[i] - p.h_deg) <= shining_deg) p.shining.push_back(static_cast<int>(i));
    p.shining_share = static_cast<double>(p.shining.size()) / static_cast<double>(p.tilt_deg.size());
    if (p.sigma_deg > 0)
        p.shining_expected = share_of_tilts(p.sigma_deg, p.h_deg, shining_deg);
    else
        p.shining_expected = std::abs(p.h_deg) <= shining_deg ? 1 : 0;
}

}  // namespace

double smith_g1(double sigma_deg, double light_deg) {
    if (!(sigma_deg > 0) || !(light_deg > 0)) return 1;
    constexpr int steps = 4096;
    const double first = 90 - light_deg, m = 1 / std::tan(light_deg * degree);
    if (first >= steepest_deg) return 1;
    double beyond = 0;
    for (int i = 0; i < steps; ++i) {
        const double tilt = first + (steepest_deg - first) * (i + 0.5) / steps;
        beyond += (std::tan(tilt * degree) - m) * tilt_density(sigma_deg, tilt);
    }
    return 1 / (1 + beyond * (steepest_deg - first) / steps / m);
}

MicrofacetPicture microfacet_picture(const MicrofacetOptions& options) {
    MicrofacetPicture p;
    p.sigma_deg = max_sigma_deg * options.roughness;
    std::mt19937 random(options.seed);
    make_profile(p, options, random);
    aim_rays(p, options, random);
    count_rays(p);
    find_shining(p, options);
    p.smith_g1 = smith_g1(p.sigma_deg, options.light_deg);
    return p;
}

}  // namespace glint
