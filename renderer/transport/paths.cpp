#include "renderer/transport/paths.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "renderer/lighting/illuminate.h"
#include "renderer/shade/light_sources.h"
#include "renderer/shade/lighting.h"
#include "renderer/simd/glm_vec3.h"

namespace glint {
namespace {

/// A light source in world coordinates.
LightSource in_world(LightSource source, const glm::dmat4& world_from_view) {
    const auto moved = [&](const Float3& v, double w) {
        return to_float3(glm::dvec3(world_from_view * glm::dvec4(v.x, v.y, v.z, w)));
    };
    source.xyz = moved(source.xyz, source.w);
    source.axis = moved(source.axis, 0);
    return source;
}

/// Estimates the reflected light from all lights as that from one random light times the number of lights.
glm::vec3 direct_light(const RayScene& rays, const TransportInputs& inputs, const PathMaterial& material,
                       const TracedPoint& point, PathRandom& random, PathStep& step) {
    const auto count = static_cast<std::uint32_t>(inputs.begins.size() - 1);
    if (count == 0) return glm::vec3(0);
    const std::uint32_t chosen = random.below(count), first = inputs.begins[chosen],
                        samples = inputs.begins[chosen + 1] - first;
    const LightSource& source = inputs.lights[first + random.below(samples)];
    step.light = source.light;
    const Equation lambert{Reflection::Lambert, {false, false, true, false}};
    SurfaceMaterial diffuse;
    diffuse.k_d = material.k_d;
    const PointAt<float> at(to_vec(point.start.p), to_vec(point.n), to_vec(point.n));
    const LightTerms<float> terms =
        illuminate(lambert, light_at<float>(source), material_at<float>(diffuse), at);
    const glm::vec3 reflected = static_cast<float>(count * samples) * to_glm(terms.diffuse);
    if (reflected == glm::vec3(0)) return reflected;
    step.reached = !rays.is_blocked(shadow_ray(source, point.start));
    return step.reached ? reflected : glm::vec3(0);
}

/// Mirrors a direction that points below the facet to the other side of the facet, so that no light is lost
/// where the shading normal differs from the facet normal.
glm::vec3 above_facet(const glm::vec3& direction, const TracedPoint& point) {
    const glm::vec3 n = glm::dot(point.start.n, point.n) < 0 ? -point.start.n : point.start.n;
    const float height = glm::dot(direction, n);
    return height < 0 ? direction - 2 * height * n : direction;
}

}  // namespace

TransportInputs transport_inputs(const Scene& scene) {
    TransportInputs inputs;
    inputs.settings = scene.transport;
    inputs.lights = light_sources(scene);
    const glm::dmat4 world = world_from_view(scene.camera);
    for (std::size_t i = 0; i < inputs.lights.size(); ++i) {
        inputs.lights[i] = in_world(inputs.lights[i], world);
        if (i == 0 || inputs.lights[i].light != inputs.lights[i - 1].light)
            inputs.begins.push_back(static_cast<std::uint32_t>(i));
    }
    inputs.begins.push_back(static_cast<std::uint32_t>(inputs.lights.size()));
    for (const Object& object : scene.objects) {
        const SurfaceMaterial m =
            surface_material(mistaken_material(scene.shading.mistakes, object.material));
        inputs.materials.push_back({m.k_d, m.emission});
    }
    inputs.any_mistake = scene.shading.mistakes != Mistakes{};
    return inputs;
}

glm::vec3 cosine_direction(PathRandom& random, const glm::vec3& n) {
    float x = 0, y = 0, squared = 0;
    do {
        const std::uint64_t bits = random.bits();
        x = static_cast<float>(bits >> 40) * 0x1p-23f - 1;
        y = static_cast<float>(bits & 0xFFFFFFu) * 0x1p-23f - 1;
        squared = x * x + y * y;
    } while (squared >= 1);
    // T. Duff et al., "Building an Orthonormal Basis, Revisited" (2017).
    const float sign = std::copysign(1.0f, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    const glm::vec3 u(1 + sign * n.x * n.x * a, sign * b, -sign * n.x), v(b, sign + n.y * n.y * a, -n.y);
    return x * u + y * v + std::sqrt(1 - squared) * n;
}

bool reaches(const RayScene& rays, const TransportInputs& inputs, const LightSource& light,
             const TracedPoint& point) {
    return !needs_shadow_ray(inputs, light, point) || !rays.is_blocked(shadow_ray(light, point.start));
}

TracedLight traced_light(const RayScene& rays, const LightSource& light, const TracedPoint& point) {
    const WorldRay ray = shadow_ray(light, point.start);
    TracedLight traced{.from = ray.from, .to = ray.from + ray.direction};
    traced.in_front = glm::dot(point.n, ray.direction) > 0;
    if (const std::optional<RayHit> hit = rays.first_hit(ray)) {
        traced.object = static_cast<int>(hit->object);
        traced.hit = rays.at_hit(ray, *hit).p;
    }
    return traced;
}

glm::vec3 radiance_of_path(const RayScene& rays, const TransportInputs& inputs, const TracedPoint& first,
                           int path, std::vector<PathStep>* steps) {
    glm::vec3 radiance(0), throughput(1);
    if (first.n == glm::vec3(0)) return radiance;
    PathRandom random(inputs.settings.seed, first.key, static_cast<std::uint64_t>(path));
    TracedPoint point = first;
    for (int bounce = 0; bounce < inputs.settings.bounces && throughput != glm::vec3(0); ++bounce) {
        const WorldRay ray = ray_along(point.start, above_facet(cosine_direction(random, point.n), point));
        const std::optional<RayHit> hit = rays.first_hit(ray);
        PathStep step{.from = ray.from, .to = ray.from + ray.direction, .throughput = throughput};
        if (hit) {
            const PathMaterial& material = inputs.materials[hit->object];
            point.start = rays.at_hit(ray, *hit);
            point.n = glm::dot(point.start.n, ray.direction) > 0 ? -point.start.n : point.start.n;
            step.object = static_cast<int>(hit->object);
            step.to = point.start.p;
            step.normal = point.n;
            step.emission = to_glm(material.emission);
            step.direct = direct_light(rays, inputs, material, point, random, step);
            radiance += throughput * (step.emission + step.direct);
            throughput *= to_glm(material.k_d);
        }
        if (steps) steps->push_back(step);
        if (!hit || point.n == glm::vec3(0)) break;
    }
    return radiance;
}

BouncedLight bounced_light(const RayScene& rays, const TransportInputs& inputs, const TracedPoint& point) {
    glm::dvec3 sum(0), squares(0);
    for (int path = 0; path < inputs.settings.paths; ++path) {
        const glm::dvec3 radiance(radiance_of_path(rays, inputs, point, path));
        sum += radiance;
        squares += radiance * radiance;
    }
    BouncedLight light{mean_of_paths(sum, inputs.settings.paths), glm::vec3(0), inputs.settings.paths};
    const double n = light.paths;
    if (n < 2) return light;
    const glm::dvec3 variance = glm::max(squares / n - sum / n * (sum / n), glm::dvec3(0));
    light.standard_error = glm::vec3(glm::sqrt(variance / (n - 1)));
    return light;
}

}  // namespace glint
