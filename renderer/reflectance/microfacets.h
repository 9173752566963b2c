#pragma once
// A rough surface in section: mirror facets whose tilt is random, a bundle of rays, and what becomes of each
// ray. The lobe of a rough surface is nothing but many mirrors. Lecture: "Types of Reflection" (microfacets);
// Torrance and Sparrow 1967 (shadowing and masking); B. Smith 1967.
//
// The plane of incidence: x along the surface, y up; angles in degrees from y, positive towards +x. The light
// stands at -light_deg, so a level facet sends it to +light_deg.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace glint {

struct MicrofacetOptions {
    double roughness =
        0.25;  // 0 to 1: tilts have a standard deviation of roughness * 90 degrees, as in Oren-Nayar
    double light_deg = 30;  // 0 to below 90
    double view_deg = 30;   // whose facets shine: those with the normal h halfway between light and viewer
    int rays = 200, facets = 400;
    std::uint32_t seed = 1;
    bool operator==(const MicrofacetOptions&) const = default;
};

/// What becomes of a ray that would meet its facet if no other stood in the way.
enum class RayFate {
    Free,      // it bounces once and is gone
    Shadowed,  // it is stopped by another facet on the way in
    Masked,    // it bounces and meets another facet on the way out
    Inward     // it bounces into the surface: below the horizon
};

struct FacetRay {
    int facet = 0;
    glm::dvec2 from{0}, at{0};  // from the light's side to the facet; shadowed: to where it is stopped
    double out_deg = 0;         // direction after the bounce, -180 to 180
    glm::dvec2 to{0};           // a point on the way out; masked: where it is stopped
    RayFate fate = RayFate::Free;
};

struct MicrofacetPicture {
    double sigma_deg = 0;
    std::vector<glm::dvec2> profile;  // #facets + 1; facet i is the line from point i to i + 1, 1 wide in x
    std::vector<double> tilt_deg;     // #facets: of the normals
    std::vector<FacetRay> rays;       // aimed at the middle half, each facet by the area that it shows the
                                      // light; none where none of them faces it
    std::vector<double> histogram;    // 36 bins of 5 degrees from -90: share of all rays that leave there
    double shadowed = 0, masked = 0, inward = 0,
           free = 0;                                 // shares of all rays, together 1 where there are any
    double smith_g1 = 1;                             // Smith's share of rays that are not shadowed
    double h_deg = 0;                                // of the half vector
    std::vector<int> shining;                        // facets whose normal is h, within shining_deg
    double shining_share = 0, shining_expected = 0;  // their share, and that of the density of tilts
};
inline constexpr double shining_deg = 2.5;
inline constexpr int histogram_bins = 36;
/// No facet is steeper: steeper tilts are drawn again.
inline constexpr double steepest_deg = 80;

/// Computes the picture. The same options give the same numbers on every machine.
[[nodiscard]] MicrofacetPicture microfacet_picture(const MicrofacetOptions& options);

/// Smith's G1 for this section's tilts: 1 / (1 + Lambda), Lambda the integral of (slope - m) over slopes
/// beyond m = cot(light_deg), over m. Assumes that heights far apart are independent.
[[nodiscard]] double smith_g1(double sigma_deg, double light_deg);

}  // namespace glint
