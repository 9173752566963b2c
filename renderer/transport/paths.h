#pragma once
// Light that arrives at a point: past everything in its way (shadow rays), and by way of other surfaces
// (paths). Source: J. Kajiya, "The Rendering Equation" (1986).
//
// A path leaves the point in a random direction, by the cosine to the normal, and goes on from each surface
// that it meets. Each surface adds what it emits and what it reflects of one light (of one sample of an area
// light), chosen at random (next-event estimation), by the diffuse part of its material: the equation of
// renderer/lighting under Lambert's law, which says that the surface reflects the fraction k_d of the light
// that arrives. A path that meets nothing brings nothing. Further surfaces are lit on the side that the path
// meets, with the normal of the facet.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"
#include "renderer/transport/ray_scene.h"
#include "renderer/transport/traced.h"

namespace glint {

// Random numbers by counting: each is a function of the seed, the lit point, the path and the number's place
// in the path. So a path is the same whichever thread follows it, and it can be followed again alone.

/// The finaliser of SplitMix64: changes about half of the bits of the result for each bit of x.
/// G. Steele, D. Lea, C. Flood, "Fast Splittable Pseudorandom Number Generators" (2014).
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The random numbers of one path.
class PathRandom {
  public:
    PathRandom(int seed, std::uint64_t point, std::uint64_t path)
        : state_(mixed(mixed(mixed(static_cast<std::uint64_t>(seed) + odd) ^ point) + path * odd)) {}

    /// 64 random bits; the k-th call of a path returns the same in every run.
    [[nodiscard]] std::uint64_t bits() { return mixed(state_ + odd * ++used_); }
    /// A number in [0, 1), a multiple of 2^-53.
    [[nodiscard]] double number() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// A whole number from 0 to below `count`.
    [[nodiscard]] std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>((bits() >> 32) * count >> 32);
    }

  private:
    static constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;
    std::uint64_t state_, used_ = 0;
};

/// A unit direction around the unit normal n, with a probability proportional to its cosine to n: a point of
/// the unit disc, raised onto the hemisphere (Malley's method). Uses only operations that round equally
/// everywhere.
[[nodiscard]] glm::vec3 cosine_direction(PathRandom& random, const glm::vec3& n);

/// The diffuse part of an object's material.
struct PathMaterial {
    Float3 k_d, emission;
    bool operator==(const PathMaterial&) const = default;
};

/// The inputs of paths and shadow rays besides the triangles; world coordinates.
struct TransportInputs {
    Transport settings;
    std::vector<LightSource> lights;      // one per sample of an area light, as light_sources() returns them
    std::vector<std::uint32_t> begins;    // the first of `lights` of each enabled light, and their number
    std::vector<PathMaterial> materials;  // of each object
    bool any_mistake = false;             // lights may add something to points that are turned away
    bool operator==(const TransportInputs&) const = default;
};
[[nodiscard]] TransportInputs transport_inputs(const Scene& scene);

/// A lit point of the picture.
struct TracedPoint {
    RayStart start;
    glm::vec3 n{0};         // unit normal of the equation, world coordinates; 0 if nothing defines it
    std::uint64_t key = 0;  // identifies the point for the random numbers
};

/// Whether a light can add something at the point only if nothing is in its way. False if it adds nothing
/// anyway, since the surface is turned away from it.
[[nodiscard]] bool needs_shadow_ray(const TransportInputs& inputs, const LightSource& light,
                                    const TracedPoint& point);
/// From the point to a light, or towards a directional light.
[[nodiscard]] WorldRay shadow_ray(const LightSource& light, const RayStart& start);
/// Whether the light reaches the point; true if it needs no shadow ray.
[[nodiscard]] bool reaches(const RayScene& rays, const TransportInputs& inputs, const LightSource& light,
                           const TracedPoint& point);

[[nodiscard]] TracedLight traced_light(const RayScene& rays, const LightSource& light,
                                       const TracedPoint& point);

/// The radiance that one path brings to the point: the sum over its steps of throughput (emission + direct).
/// `steps`: if not null, gets the steps.
[[nodiscard]] glm::vec3 radiance_of_path(const RayScene& rays, const TransportInputs& inputs,
                                         const TracedPoint& point, int path,
                                         std::vector<PathStep>* steps = nullptr);

/// Arrivals::bounced of a point from the sum of its paths' radiance.
[[nodiscard]] inline glm::vec3 mean_of_paths(const glm::dvec3& sum, int paths) {
    return glm::vec3(sum / static_cast<double>(paths));
}

/// All paths of a point, followed alone.
struct BouncedLight {
    glm::vec3 mean{0};            // as the picture has it
    glm::vec3 standard_error{0};  // of the mean, estimated from the paths' variance; 0 for a single path
    int paths = 0;
};
[[nodiscard]] BouncedLight bounced_light(const RayScene& rays, const TransportInputs& inputs,
                                         const TracedPoint& point);

}  // namespace glint
