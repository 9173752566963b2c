#include "renderer/transport/form_factor.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "renderer/threads.h"
#include "renderer/transport/paths.h"

namespace glint {
namespace {

/// Samples points of an object uniformly by area.
class EmittingObject {
    using Corners = std::array<glm::dvec3, 3>;

  public:
    EmittingObject(const Object& object, std::uint32_t number) : number_(number) {
        const glm::dmat4 world = world_from_object(object.transform);
        const Mesh& mesh = *object.mesh;
        double sum = 0;
        for (const Triangle& t : mesh.triangles) {
            Corners c;
            for (std::size_t k = 0; k < 3; ++k)
                c[k] = glm::dvec3(
                    world * glm::dvec4(glm::dvec3(mesh.positions[mesh.corner_position[t.corner[k]]]), 1));
            sum += glm::length(glm::cross(c[1] - c[0], c[2] - c[0])) / 2;
            corners_.push_back(c);
            area_to_.push_back(sum);
        }
        const glm::vec3& s = object.transform.scale;
        outside_ = s.x * s.y * s.z < 0 ? -1.0f : 1.0f;
    }

    [[nodiscard]] double area() const { return area_to_.empty() ? 0 : area_to_.back(); }

    [[nodiscard]] WorldRay ray(const RayScene& rays, PathRandom& random) const {
        const double at = random.number() * area();
        const auto triangle = static_cast<std::size_t>(
            std::upper_bound(area_to_.begin(), area_to_.end() - 1, at) - area_to_.begin());
        const Corners& c = corners_[triangle];
        // Uniform over a parallelogram; points beyond the diagonal are reflected into the triangle.
        double u = random.number(), v = random.number();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const glm::dvec3 p = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
        const RayStart start = rays.on_triangle({number_, static_cast<std::uint32_t>(triangle)}, p);
        return ray_along(start, cosine_direction(random, outside_ * start.n));
    }

  private:
    std::uint32_t number_;
    std::vector<Corners> corners_;  // of each triangle, world coordinates
    std::vector<double> area_to_;   // cumulative area up to each triangle
    float outside_ = 1;             // -1 for a mirrored object
};

}  // namespace

FormFactor form_factor(const Scene& scene, std::size_t from, std::size_t to, int count, int seed,
                       int threads) {
    FormFactor factor;
    tbb::task_arena arena(arena_threads(threads));
    arena.execute([&] {
        RayScene rays;
        rays.update(scene);
        const EmittingObject emitting(scene.objects[from], static_cast<std::uint32_t>(from));
        factor.area = emitting.area();
        if (!(factor.area > 0)) return;
        factor.rays = count;
        factor.arrived = tbb::parallel_reduce(
            tbb::blocked_range<int>(0, count, 4096), std::int64_t{0},
            [&](const auto& range, std::int64_t arrived) {
                for (int i = range.begin(); i != range.end(); ++i) {
                    PathRandom random(seed, 0, static_cast<std::uint64_t>(i));
                    const auto hit = rays.first_hit(emitting.ray(rays, random));
                    if (hit && hit->object == to) ++arrived;
                }
                return arrived;
            },
            std::plus<>());
    });
    if (factor.rays == 0) return factor;
    const auto n = static_cast<double>(factor.rays);
    factor.estimate = static_cast<double>(factor.arrived) / n;
    if (n > 1) factor.standard_error = std::sqrt(factor.estimate * (1 - factor.estimate) / (n - 1));
    return factor;
}

}  // namespace glint
