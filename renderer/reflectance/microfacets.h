#pragma once
// A cross-section of a rough surface: mirror facets with random tilts, and a bundle of rays with the outcome
// of each ray. The lobe of a rough surface is the sum of many mirrors. Lecture: "Types of Reflection"
// (microfacets); Torrance and Sparrow 1967 (shadowing and masking); B. Smith 1967.
//
// The plane of incidence has x along the surface and y up. Angles are in degrees from y, positive towards +x.
// The light is at -light_deg, so a level facet reflects it to +light_deg.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace glint {

struct MicrofacetOptions {
    // 0 to 1. Tilts have a standard deviation of roughness * 90 degrees, as in Oren-Nayar.
    double roughness = 0.25;
    double light_deg = 30;  // at least 0, below 90
    // Facets whose normal is h, halfway between light and viewer, reflect towards the viewer.
    double view_deg = 30;
    int rays = 200, facets = 400;
    std::uint32_t seed = 1;
    bool operator==(const MicrofacetOptions&) const = default;
};

/// The outcome of a ray that is aimed at a facet.
enum class RayFate {
    Free,      // reflected once, then leaves the surface
    Shadowed,  // blocked by another facet before reaching its own
    Masked,    // blocked by another facet after the reflection
    Inward     // reflected below the horizon, into the surface
};

struct FacetRay {
    int facet = 0;
    glm::dvec2 from{0}, at{0};  // from the light's side to the facet; if shadowed, to the blocking facet
    double out_deg = 0;         // direction after the reflection, -180 to 180
    glm::dvec2 to{0};           // a point after the reflection; if masked, on the blocking facet
    RayFate fate = RayFate::Free;
};

struct MicrofacetPicture {
    double sigma_deg = 0;
    std::vector<glm::dvec2> profile;  // #facets + 1; facet i connects points i and i + 1 and is 1 wide in x
    std::vector<double> tilt_deg;     // #facets: tilts of the normals
    std::vector<FacetRay> rays;  // aimed at the middle half, in proportion to each facet's area seen from the
                                 // light; empty if none faces it
    std::vector<double> histogram;  // 36 bins of 5 degrees from -90: fraction of all rays leaving in each
    double shadowed = 0, masked = 0, inward = 0,
           free = 0;                                 // fractions of all rays; they sum to 1 if there are rays
    double smith_g1 = 1;                             // Smith's fraction of rays that are not shadowed
    double h_deg = 0;                                // angle of the half vector
    std::vector<int> shining;                        // facets whose normal is h, within shining_deg
    double shining_share = 0, shining_expected = 0;  // measured and expected fraction of such facets
};
inline constexpr double shining_deg = 2.5;
inline constexpr int histogram_bins = 36;
/// The maximum tilt in degrees. Steeper facets are resampled.
inline constexpr double steepest_deg = 80;

/// Computes the cross-section. The same options give the same numbers on every platform.
[[nodiscard]] MicrofacetPicture microfacet_picture(const MicrofacetOptions& options);

/// Smith's G1 for this cross-section's tilts: 1 / (1 + Lambda), where Lambda is the integral of (slope - m)
/// over slopes beyond m = cot(light_deg), divided by m. Assumes that distant heights are independent.
[[nodiscard]] double smith_g1(double sigma_deg, double light_deg);

}  // namespace glint
