#pragma once
// Samples how a reflection model reflects light from one direction: slices f(l, v) for plots, and properties
// of the entire lobe: energy, albedo and reciprocity. All values come from the equation's own illuminate().
// Lecture: "Types of Reflection", "BRDF", the intensity plots at 60, 25 and 0 degrees.
//
// The surface has n = (0, 0, 1). The light is white, of intensity 1, at `light_deg` from n on the -x side, so
// the mirror direction is at the same angle towards +x.

#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/illuminate.h"

namespace glint {

/// A surface: its reflection model and material.
struct Reflector {
    Reflection reflection = Reflection::Phong;
    Material material;
    Terms terms;
    bool operator==(const Reflector&) const = default;
};
/// The surface that this material has in a scene with this shading.
[[nodiscard]] inline Reflector reflector_of(const Material& material, const Shading& shading) {
    return {reflection_of(material, shading.reflection), material, shading.terms};
}

/// The terms of the equation, per channel. `ambient` is k_a, as for a light with an ambient colour of 1.
struct Reflected {
    glm::vec3 ambient{0}, diffuse{0}, specular{0};
    [[nodiscard]] glm::vec3 intensity() const { return ambient + diffuse + specular; }
};

/// l, v: unit vectors towards light and viewer. n = (0, 0, 1).
[[nodiscard]] Reflected reflected(const Reflector& reflector, glm::vec3 l, glm::vec3 v);

/// f = (diffuse + specular) / (pi n.l), 1/sr. The factor pi is needed because the equation's Lambert term is
/// k_d n.l for a surface whose f is k_d / pi. 0 if light or viewer is not above the surface.
[[nodiscard]] glm::vec3 brdf(const Reflector& reflector, glm::vec3 l, glm::vec3 v);

/// The direction at `deg` from n in the plane of incidence, positive on the mirror side. The light's
/// direction is in_plane(-light_deg).
[[nodiscard]] glm::vec3 in_plane(double deg);

struct LobeSample {
    double view_deg = 0;  // angle between v and n, positive on the mirror side
    Reflected reflected;
    glm::vec3 brdf{0};
};
/// Samples the lobe from -90 to 90 degrees in the plane of incidence in `steps` steps. 0 <= light_deg < 90,
/// steps >= 1.
[[nodiscard]] std::vector<LobeSample> lobe_slice(const Reflector& reflector, double light_deg, int steps);

/// The integral of the specular term times n.v over all v: for Phong at light_deg = 0 it is k_s 2 pi /
/// (shininess + 2).
[[nodiscard]] glm::dvec3 specular_energy(const Reflector& reflector, double light_deg);
/// The reflected fraction of the light's power, which is the integral of f n.v over all v. Above 1, the
/// surface would create energy.
[[nodiscard]] glm::dvec3 directional_albedo(const Reflector& reflector, double light_deg);

/// Largest |f(l, v) - f(v, l)| / max(f(l, v), f(v, l)) over 4096 pairs of directions with cosines above 0.05.
/// 0, up to rounding, for a reciprocal surface (Helmholtz). The numbers are the same in every run.
[[nodiscard]] double reciprocity_error(const Reflector& reflector);

/// A header and one line per sample: view_deg, then r, g, b of ambient, diffuse, specular, intensity and
/// brdf.
[[nodiscard]] std::string lobe_csv(const std::vector<LobeSample>& slice);

// A microfacet lobe in space. Facets drawn from the GGX density reflect rays, and the histogram of the
// outgoing directions converges to D(h) (n.h) / (4 v.h), the lobe of cook-torrance before shadowing and
// Fresnel. Lecture: microfacets; B. Walter et al. 2007 for the sampling.

/// A random facet normal about n = (0, 0, 1), with density D(h) (n.h): tan(angle) = a sqrt(u / (1 - u)), a =
/// roughness^2.
[[nodiscard]] glm::dvec3 sampled_normal(double roughness, std::mt19937& random);

struct LobeBin {
    double from_deg = 0, to_deg = 0;  // angles between the outgoing direction and n
    double share = 0, expected = 0;   // fraction of all rays: measured, and predicted by the density
};
/// Reflects `rays` rays from view_deg at facets that face them. Returns 18 bins of 5 degrees from n. Rays
/// that leave below the horizon are not counted in any bin. D is the equation's own d_ggx.
[[nodiscard]] std::vector<LobeBin> facet_lobe(double roughness, double view_deg, int rays,
                                              std::uint32_t seed);

// A scene with one light, for measuring single lights.

/// The light, enabled, white and of intensity 1, ignoring its own diffuse and specular colours.
[[nodiscard]] Light white(Light light);

/// The scene's camera and shading with only this light, enabled, and no objects.
[[nodiscard]] Scene alone(const Scene& scene, const Light& light);

/// Evaluates the picture's equation, including mistakes, for one light at any point of a material. Treats the
/// light as white, of intensity 1 and enabled. Uses the camera and shading of the scene, with diffuse and
/// specular terms enabled. Points and normals are in camera coordinates.
class LightAlone {
  public:
    LightAlone(const Scene& scene, PictureSize size, const Light& light, const Material& material);
    LightAlone(const LightAlone&) = delete;  // the job points to the sources
    LightAlone& operator=(const LightAlone&) = delete;

    [[nodiscard]] PointAt<float> seen(glm::vec3 position, glm::vec3 normal) const;
    /// The light itself or, for an area light, each of its samples.
    [[nodiscard]] const std::vector<LightSource>& sources() const { return sources_; }
    [[nodiscard]] LightTerms<float> terms(const LightSource& source, const PointAt<float>& at) const;
    /// The light's terms; for an area light, those of its middle sample (the third if there are four).
    [[nodiscard]] LightTerms<float> middle(const PointAt<float>& at) const {
        return terms(sources_[sources_.size() / 2], at);
    }

  private:
    std::vector<LightSource> sources_;
    LightJob job_;
};

// Random numbers that are the same on every platform. Uses the bits of a generator directly, because the
// distributions of std:: differ between libraries.

/// A uniformly distributed number in [0, 1).
[[nodiscard]] inline double uniform(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

}  // namespace glint
