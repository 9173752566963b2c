#pragma once
// Light that arrives at a point directly (shadow rays) and via other surfaces (paths). Source: J. Kajiya,
// "The Rendering Equation" (1986).
// A path leaves the point in a random direction, with a probability proportional to the cosine of its angle
// with the normal, and continues from each surface that it hits. Each surface adds its emission and the
// reflected light from one randomly chosen light, or from one sample of an area light (next-event
// estimation). A surface reflects with the diffuse part of its material: the equation of renderer/lighting
// under Lambert's law, in which the surface reflects the fraction k_d of the incoming light. A path that hits
// nothing contributes nothing. Surfaces along the path are lit on the side that the path hits, with the facet
// normal.

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

// Counter-based random numbers: each is a function of the seed, the lit point, the path and the position in
// the path. A path is therefore the same on any thread, and a single path can be traced again.

/// The finalizer of SplitMix64: each bit of x affects about half of the bits of the result. G. Steele, D.
/// Lea, C. Flood, "Fast Splittable Pseudorandom Number Generators" (2014).
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

    /// 64 random bits. The k-th call for a path returns the same bits in every run.
    [[nodiscard]] std::uint64_t bits() { return mixed(state_ + odd * ++used_); }
    /// A number in [0, 1), a multiple of 2^-53.
    [[nodiscard]] double number() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// An integer from 0 to `count` - 1.
    [[nodiscard]] std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>((bits() >> 32) * count >> 32);
    }

  private:
    static constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;
    std::uint64_t state_, used_ = 0;
};

/// A unit direction around the unit normal n, with a probability proportional to the cosine of its angle with
/// n: a point in the unit disc, projected onto the hemisphere (Malley's method). Uses only operations that
/// round identically on every platform.
[[nodiscard]] glm::vec3 cosine_direction(PathRandom& random, const glm::vec3& n);

/// The diffuse part of an object's material.
struct PathMaterial {
    Float3 k_d, emission;
    bool operator==(const PathMaterial&) const = default;
};

/// The inputs of paths and shadow rays apart from the triangles, in world coordinates.
struct TransportInputs {
    Transport settings;
    std::vector<LightSource> lights;  // one per sample of an area light, as light_sources() returns them
    // For each enabled light, the index of its first source in `lights`; at the end, the number of sources.
    std::vector<std::uint32_t> begins;
    std::vector<PathMaterial> materials;  // of each object
    bool any_mistake = false;             // lights may affect points that face away
    bool operator==(const TransportInputs&) const = default;
};
[[nodiscard]] TransportInputs transport_inputs(const Scene& scene);

/// A lit point of the picture.
struct TracedPoint {
    RayStart start;
    glm::vec3 n{0};         // unit shading normal, world coordinates; 0 if undefined
    std::uint64_t key = 0;  // identifies the point for the random numbers
};

// Inline, because a picture needs millions of shadow rays.

inline glm::vec3 to_glm(const Float3& v) { return {v.x, v.y, v.z}; }

/// Whether the light contributes to the point unless it is blocked. False if it contributes nothing anyway
/// because the surface faces away from it.
[[nodiscard]] inline bool needs_shadow_ray(const TransportInputs& inputs, const LightSource& light,
                                           const TracedPoint& point) {
    const glm::vec3 xyz = to_glm(light.xyz);
    return glm::dot(point.n, light.w > 0 ? xyz - point.start.p : xyz) > 0 || inputs.any_mistake ||
           light.ambient != Float3{};
}
/// The ray from the point to a light, or towards a directional light.
[[nodiscard]] inline WorldRay shadow_ray(const LightSource& light, const RayStart& start) {
    return light.w > 0 ? ray_to(start, to_glm(light.xyz)) : ray_along(start, to_glm(light.xyz));
}
/// Whether the light reaches the point; true if no shadow ray is needed.
[[nodiscard]] bool reaches(const RayScene& rays, const TransportInputs& inputs, const LightSource& light,
                           const TracedPoint& point);

[[nodiscard]] TracedLight traced_light(const RayScene& rays, const LightSource& light,
                                       const TracedPoint& point);

/// The radiance that one path carries to the point: the sum over its steps of throughput (emission + direct).
/// `steps`: if not null, receives the steps.
[[nodiscard]] glm::vec3 radiance_of_path(const RayScene& rays, const TransportInputs& inputs,
                                         const TracedPoint& point, int path,
                                         std::vector<PathStep>* steps = nullptr);

/// Computes Arrivals::bounced of a point from the sum of its paths' radiance.
[[nodiscard]] inline glm::vec3 mean_of_paths(const glm::dvec3& sum, int paths) {
    return glm::vec3(sum / static_cast<double>(paths));
}

/// All paths of a single point.
struct BouncedLight {
    glm::vec3 mean{0};            // as in the picture
    glm::vec3 standard_error{0};  // of the mean, estimated from the paths' variance; 0 for a single path
    int paths = 0;
};
[[nodiscard]] BouncedLight bounced_light(const RayScene& rays, const TransportInputs& inputs,
                                         const TracedPoint& point);

}  // namespace glint
