#include "renderer/debug_views/blocker.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "models/scene/transform.h"

namespace glint {
namespace {

struct Ray {
    glm::dvec3 from, along;  // object coordinates; `along` spans one unit of the ray parameter
};

/// Whether the ray meets the box between `near` and `far`.
bool meets(const Ray& ray, const Bounds& box, double near, double far) {
    for (int i = 0; i < 3; ++i) {
        const double low = double(box.min[i]) - ray.from[i], high = double(box.max[i]) - ray.from[i];
        if (ray.along[i] == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const double a = low / ray.along[i], b = high / ray.along[i];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far * (1 + 1e-12);  // tolerance for a flat box
}

/// The ray parameter at which the ray hits the triangle from either side; infinity if it misses.
/// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
double met_at(const Ray& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const glm::dvec3 u = b - a, v = c - a, p = glm::cross(ray.along, v);
    const double det = glm::dot(u, p);
    if (det == 0) return never;
    const glm::dvec3 to = ray.from - a;
    const double s = glm::dot(to, p) / det;
    if (!(s >= 0 && s <= 1)) return never;
    const glm::dvec3 q = glm::cross(to, u);
    const double t = glm::dot(ray.along, q) / det;
    if (!(t >= 0 && s + t <= 1)) return never;
    return glm::dot(v, q) / det;
}

/// The ray parameter of the nearest hit on the mesh between `near` and `far`; infinity without one.
double nearest_of(const Mesh& mesh, const Ray& ray, double near, double far) {
    double nearest = std::numeric_limits<double>::infinity();
    if (!meets(ray, mesh.bounds, near, far)) return nearest;
    const auto place = [&](std::uint32_t corner) {
        return glm::dvec3(mesh.positions[mesh.corner_position[corner]]);
    };
    for (const Triangle& triangle : mesh.triangles) {
        const double at =
            met_at(ray, place(triangle.corner[0]), place(triangle.corner[1]), place(triangle.corner[2]));
        if (at > near && at < std::min(far, nearest)) nearest = at;
    }
    return nearest;
}

}  // namespace

std::optional<int> blocker(const Scene& scene, glm::dvec3 point, glm::dvec3 to_light, double distance) {
    std::optional<int> found;
    double nearest = distance > 0 ? distance : std::numeric_limits<double>::infinity();
    const glm::dvec3 way = glm::normalize(to_light);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (!object.mesh || !object.visible) continue;
        const glm::dmat4 world = glm::dmat4(world_from_object(object.transform));
        const double volume = glm::determinant(glm::dmat3(world));
        if (volume == 0) continue;  // flattened: the transform has no inverse
        const glm::dmat4 back = glm::inverse(world);
        const Ray ray{glm::dvec3(back * glm::dvec4(point, 1)), glm::dvec3(back * glm::dvec4(way, 0))};
        const glm::dvec3 size = glm::dvec3(object.mesh->bounds.max) - glm::dvec3(object.mesh->bounds.min);
        const double near = 1e-3 * glm::length(size) / glm::length(ray.along);
        const double at = nearest_of(*object.mesh, ray, near, nearest);
        if (at >= nearest) continue;
        nearest = at;
        found = static_cast<int>(i);
    }
    return found;
}

}  // namespace glint
