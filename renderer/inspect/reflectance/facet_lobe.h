#pragma once
// A microfacet lobe in space: facets drawn from the GGX density bounce a ray, and the directions in which it
// leaves, counted, tend to D(h) (n.h) / (4 v.h), the lobe of cook-torrance before shadowing and Fresnel.
// Lecture: microfacets; B. Walter and others 2007 for the sampling.

#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

namespace glint {

/// A facet's normal about n = (0, 0, 1), with density D(h) (n.h): tan(angle) = a sqrt(u / (1 - u)), a =
/// roughness^2.
[[nodiscard]] glm::dvec3 sampled_normal(double roughness, std::mt19937& random);

struct LobeBin {
    double from_deg = 0, to_deg = 0;  // of the direction out, from n
    double share = 0, expected = 0;   // of all rays: counted, and by the density
};
/// `rays` rays from view_deg, bounced by facets that they see from the front; 18 bins of 5 degrees from n.
/// What leaves below the horizon is in no bin. D is the equation's own d_ggx.
[[nodiscard]] std::vector<LobeBin> facet_lobe(double roughness, double view_deg, int rays,
                                              std::uint32_t seed);

}  // namespace glint
